// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <io/shifted_cloud.h>
#include <pcl_ops/plane_extent.h>

#include <string>
#include <vector>

namespace pcl_ops::apps {

/** \brief What --hull can be; the first is its default. */
extern const std::vector<std::string> hulls;

/** \brief Whether this build has the library that concave hulls need. */
bool
hasHull (const std::string& hull);

/** \brief Where a plane ends, in the file's frame; parameters as below. */
PlaneExtent
extentInFile (const ShiftedCloud& shifted,
              const PlaneSegment& plane,
              const std::string& hull);

/** \brief Where each plane ends, in the file's frame.
 * \param[in] shifted the cloud the planes were found in
 * \param[in] planes in the file's frame
 * \param[in] hull one of \ref hulls that the build has */
std::vector<PlaneExtent>
extentsOf (const ShiftedCloud& shifted,
           const std::vector<PlaneSegment>& planes,
           const std::string& hull);

} // namespace pcl_ops::apps
