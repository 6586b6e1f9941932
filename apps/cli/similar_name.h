// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace pcl_ops::apps {

/** \brief Returns the name that a mistyped one most likely means: the first of those
 * with the fewest edits, where a letter is inserted, deleted, changed or swapped with
 * the next. Empty if all names take more edits than a third of the mistyped letters, or
 * if these are more than 64. */
std::string
similarName (const std::string& mistyped, const std::vector<std::string>& names);

} // namespace pcl_ops::apps
