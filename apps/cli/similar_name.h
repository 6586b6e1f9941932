// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace pcl_ops::apps {

/** \brief Returns the name that a mistyped one most likely means: the first one with
 * the fewest edits between both. An edit inserts, deletes or changes a letter, or swaps
 * it with the next. Empty if every name takes more edits than a third of the number of
 * letters of \p mistyped, or if \p mistyped has more than 64 letters. */
std::string
similarName (const std::string& mistyped, const std::vector<std::string>& names);

} // namespace pcl_ops::apps
