// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace pcl_ops::fuzz {

/** \brief An input of the fuzzer or of the corpus. */
using Bytes = std::vector<std::uint8_t>;

/** \brief Checks a property that must hold for every input.
 * \throw std::logic_error if it does not hold */
inline void
promise (bool holds, const std::string& what)
{
  if (!holds)
    throw std::logic_error ("broken promise: " + what);
}

using Targets = std::map<std::string, void (*) (const Bytes&)>;

/** \brief All targets by name. The archive test/fuzz/corpus/NAME.tar.gz has the corpus
 * of a target: the inputs that fuzzing begins with.
 *
 * - "pcd", "ply", "las", "ascii", "ptx", "kitti", "npy", "off" and "obj" load bytes as
 * a file. Loading must return a cloud that has points and consistent sizes, fail with
 * an error of one line, or run out of memory. Except for "pcd" and "ply", the cloud is
 * saved and must be the same when it is loaded again; a LAS with labels, if it takes
 * them.
 * - "options" reads a command line argument from each line and detects planes in a
 * small cloud.
 * - The other targets detect planes by one method, with parameters and a cloud made
 * from the bytes. promiseOrderedPlanes says what must hold for the planes. */
const Targets&
allTargets ();

} // namespace pcl_ops::fuzz
