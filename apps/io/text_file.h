// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/PCLPointCloud2.h>

#include <string>

namespace pcl_ops::apps {

/** \brief Whether a file has the extension of a cloud that is text: .xyz, .txt, .pts or
 * .csv. */
bool
isTextFile (const std::string& file);

/** \brief Reads a cloud of a line for each point: x, y and z and further columns of
 * numbers, each a field in double precision, separated by blanks, commas or semicolons.
 *
 * In front of the points there may be the names of the columns and, in a line of its
 * own, their number; lines that begin with # or // are comments, of which one with x, y
 * and z has names, too.
 *
 * pcl::ASCIIReader wants to be told the columns, has no header, and leaves out without
 * a word every line it does not understand, which is how a decimal comma or a cut file
 * becomes another cloud.
 * \throws WorkError naming the line at fault, or if there is no point */
pcl::PCLPointCloud2
readTextCloud (const std::string& file);

} // namespace pcl_ops::apps
