// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace pcl_ops::internal::buildings {

/** \brief Cross product of two vectors: twice the signed area of their triangle,
 * positive if the second one is to the left of the first. */
inline double
cross (const Eigen::Vector2d& first, const Eigen::Vector2d& second)
{
  return first.x() * second.y() - first.y() * second.x();
}

/** \brief Signed area of a polygon: positive if it runs counter-clockwise. */
inline double
areaOf (const std::vector<Eigen::Vector2d>& polygon)
{
  double twice_area = 0.0;
  // Relative to the first corner: products of large coordinates would cancel.
  for (std::size_t i = 2; i < polygon.size(); ++i)
    twice_area += cross (polygon[i - 1] - polygon[0], polygon[i] - polygon[0]);
  return 0.5 * twice_area;
}

/** \brief Returns whether a position is inside a polygon, clockwise or
 * counter-clockwise: whether a ray from it along x crosses an odd number of sides. */
inline bool
isWithinRing (const std::vector<Eigen::Vector2d>& ring, const Eigen::Vector2d& position)
{
  bool is_within = false;
  for (std::size_t i = 0, last = ring.size() - 1; i < ring.size(); last = i++) {
    const Eigen::Vector2d& a = ring[i];
    const Eigen::Vector2d& b = ring[last];
    const bool reaches_height = (a.y() > position.y()) != (b.y() > position.y());
    if (reaches_height &&
        position.x() <
            (b.x() - a.x()) * (position.y() - a.y()) / (b.y() - a.y()) + a.x())
      is_within = !is_within;
  }
  return is_within;
}

} // namespace pcl_ops::internal::buildings
