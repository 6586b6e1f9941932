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

} // namespace pcl_ops::apps
