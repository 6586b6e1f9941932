// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace pcl_ops::apps {

/** \brief The name that a mistyped one most likely means: the first of those that the
 * fewest letters lead to, which are put in, left out, changed or swapped with the next.
 * Empty where more than a third of its letters would be wrong. */
std::string
similarName (const std::string& mistyped, const std::vector<std::string>& names);

} // namespace pcl_ops::apps
