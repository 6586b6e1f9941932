// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace pcl_ops::apps {

/** \brief Checks that a PCD file's header makes sense and that its data is as long as
 * the header says and, where it is text, all numbers, so that PCL's reader can be given
 * the file. \throws WorkError naming the line at fault */
void
checkPcdFile (const std::string& file);

} // namespace pcl_ops::apps
