// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud_file.h"

#include <string>

namespace pcl_ops::apps {

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

} // namespace pcl_ops::apps
