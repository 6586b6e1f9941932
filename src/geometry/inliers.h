// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/plane.h>

#include <cstddef>
#include <stdexcept>

namespace pcl_ops::internal {

/** \brief Checks that all inliers of a plane are indices of points of the cloud.
 * \throw std::invalid_argument if an index is negative or not below the cloud's size */
inline void
checkInliers (const CloudView& cloud, const PlaneSegment& plane)
{
  for (const pcl::index_t index : plane.inliers)
    if (index < 0 || static_cast<std::size_t> (index) >= cloud.size)
      throw std::invalid_argument (
          "an inlier lies outside the cloud; give the one the planes are of");
}

} // namespace pcl_ops::internal
