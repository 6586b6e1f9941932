// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/PCLPointCloud2.h>

#include <string>

namespace pcl_ops::apps {

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
