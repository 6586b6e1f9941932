// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace pcl_ops::fuzz {

/** \brief What a fuzzer makes up. */
using Bytes = std::vector<std::uint8_t>;

/** \brief Of something that holds for whatever comes in. */
inline void
promise (bool holds, const std::string& what)
{
  if (!holds)
    throw std::logic_error ("broken promise: " + what);
}

using Targets = std::map<std::string, void (*) (const Bytes&)>;

/** \brief All by their names; the corpus of each is the folder of that name. "pcd",
 * "ply", "las", "ascii", "ptx", "kitti", "npy", "off" and "obj" load bytes as a file: a
 * cloud whose sizes agree, or an error of one line; from "ascii" on each number is
 * written again, and a LAS is labeled, where it takes labels. "options" takes lines for
 * what stands on a command line, and detects planes in a small cloud by it. The others
 * detect planes, with parameters and in a cloud made up from bytes, by a method: see
 * promiseOrderedPlanes. */
const Targets&
allTargets ();

} // namespace pcl_ops::fuzz
