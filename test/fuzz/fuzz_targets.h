// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "byte_reader.h"

#include <map>
#include <stdexcept>
#include <string>

namespace pcl_ops::fuzz {

/** \brief Something that holds for whatever comes in did not. */
struct BrokenPromise : std::logic_error {
  using std::logic_error::logic_error;
};

/** \brief \throws BrokenPromise unless it holds */
inline void
promise (bool holds, const std::string& what)
{
  if (!holds)
    throw BrokenPromise ("broken promise: " + what);
}

/** \brief Loads bytes as a file: a cloud whose sizes agree, or an error of one line. */
void
loadPcd (const Bytes& bytes);
void
loadPly (const Bytes& bytes);

/** \brief And writes it as a PCD, which has every number again. */
void
loadText (const Bytes& bytes);

/** \brief And labels it, where it takes labels: they and the points are read back. */
void
loadLas (const Bytes& bytes);

/** \brief Takes lines for what stands on a command line, and detects planes in a small
 * cloud by it: planes, or an error of one line. */
void
readOptions (const Bytes& bytes);

/** \brief Detects planes with parameters and in a cloud made up from bytes: see
 * promiseOrderedPlanes. */
void
detectByOps (const Bytes& bytes);
void
detectByPublishedOps (const Bytes& bytes);
void
detectByFspf (const Bytes& bytes);
void
detectByKht (const Bytes& bytes);
void
detectByPublishedKht (const Bytes& bytes);

/** \brief All of these by their names; the corpus of each is the folder of that name.
 */
const std::map<std::string, void (*) (const Bytes&)>&
allTargets ();

} // namespace pcl_ops::fuzz
