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

} // namespace pcl_ops::apps
