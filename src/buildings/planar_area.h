// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace pcl_ops::internal::buildings {

/** \brief Cross product of two vectors: twice the signed area of the triangle that they
 * span, positive if the second vector points to the left of the first. */
inline double
cross (const Eigen::Vector2d& first, const Eigen::Vector2d& second)
{
  return first.x() * second.y() - first.y() * second.x();
}

/** \brief Signed area of a polygon: positive if it runs counter-clockwise; 0 for fewer
 * than 3 corners. */
inline double
areaOf (const std::vector<Eigen::Vector2d>& polygon)
{
  double twice_area = 0.0;
  // Relative to the first corner: products of large coordinates would cancel.
  for (std::size_t i = 2; i < polygon.size(); ++i)
    twice_area += cross (polygon[i - 1] - polygon[0], polygon[i] - polygon[0]);
  return 0.5 * twice_area;
}

/** \brief Returns whether a position is inside a polygon, which may run clockwise or
 * counter-clockwise: whether a ray from the position along x crosses an odd number of
 * sides.
 * \param[in] ring at least one corner */
inline bool
isWithinRing (const std::vector<Eigen::Vector2d>& ring, const Eigen::Vector2d& position)
{
  bool is_within = false;
  for (std::size_t i = 0, previous = ring.size() - 1; i < ring.size(); previous = i++) {
    const Eigen::Vector2d& a = ring[i];
    const Eigen::Vector2d& b = ring[previous];
    const bool crosses_y = (a.y() > position.y()) != (b.y() > position.y());
    if (crosses_y &&
        position.x() <
            (b.x() - a.x()) * (position.y() - a.y()) / (b.y() - a.y()) + a.x())
      is_within = !is_within;
  }
  return is_within;
}

} // namespace pcl_ops::internal::buildings
