// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/cloud_view.h>
#include <pcl_ops/plane.h>

#include <cstddef>
#include <stdexcept>
#include <string>

// Checks of the arguments of public functions.
namespace pcl_ops::internal::buildings {

/** \brief Throws std::invalid_argument with the text \p problem unless it is empty. */
inline void
throwIfWrong (const std::string& problem)
{
  if (!problem.empty())
    throw std::invalid_argument (problem);
}

/** \brief Throws std::invalid_argument if an inlier is no index into the cloud. */
inline void
checkInliers (const CloudView& cloud, const PlaneSegment& plane)
{
  for (const pcl::index_t index : plane.inliers)
    if (index < 0 || static_cast<std::size_t> (index) >= cloud.size)
      throw std::invalid_argument (
          "an inlier lies outside the cloud; give the one the planes are of");
}

} // namespace pcl_ops::internal::buildings
