// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud_file.h"

#include <string>

namespace pcl_ops::apps {

/** \brief Writes a binary little endian PLY in one step (\ref writeFile): every field
 * with its type, except that of `rgb` and `rgba` the first becomes red, green, blue
 * (and alpha), 64-bit integers, which PLY has none of, become doubles, and the numbers
 * of a field of several become properties NAME_0, NAME_1, ...
 *
 * Normals get the names other programs know them by: nx, ny, nz. PCL's own writer takes
 * a name and so writes past the check, and puts a camera behind the points.
 * \throws WorkError if it cannot be written */
void
savePly (const std::string& file, const FileCloud& cloud);

} // namespace pcl_ops::apps
