// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud_file.h"

#include <string>

namespace pcl_ops::apps {

/** \brief Reads a PCD of any kind.
 * \throws WorkError naming the line at fault, or that data are missing */
FileCloud
readPcd (const std::string& file);

/** \brief The header of a binary PCD, whose data are those of the points. */
std::string
pcdHeader (const FileCloud& cloud);

/** \brief Reads the vertices of a PLY, with the names that PCL has for fields: red,
 * green, blue (and alpha) become `rgb` (`rgba`), nx `normal_x`, and so on. The cloud is
 * organized where num_cols and num_rows or PCL's camera say so.
 * \throws WorkError naming the line at fault, or that data are missing */
FileCloud
readPly (const std::string& file);

/** \brief Header of a binary little endian PLY: every field with its type, except that
 * of `rgb` and `rgba` the first becomes red, green, blue (and alpha), 64-bit integers,
 * which PLY lacks, become doubles, the numbers of a field of several become properties
 * NAME_0, NAME_1, ..., and normals get the names other programs know: nx, ny, nz. */
std::string
plyHeader (const pcl::PCLPointCloud2& points);

/** \brief The numbers of its points, as they follow in that file. */
std::string
plyVertices (const pcl::PCLPointCloud2& points);

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
FileCloud
readTextCloud (const std::string& file);

} // namespace pcl_ops::apps
