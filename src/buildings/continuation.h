// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <vector>

// Tells ground from roofs and ceilings by the planes that continue it or lie below it.
namespace pcl_ops::internal::buildings {

/** \brief A plane seen from above, in meters, in a frame whose z is up. */
struct PlaneFromAbove {
  /** \brief Unit normal that points up. */
  Eigen::Vector3d normal;
  Eigen::Vector3d center;
  /** \brief Corners of its convex outline, in order; empty for a steep plane. */
  std::vector<Eigen::Vector3d> hull;
  double area; // inside the outline [m^2], also of a steep plane
};

/** \brief Returns whether a plane is a part of the ground and not a roof. Samples along
 * its outline decide. Where another plane lies far below a sample, the plane is like a
 * roof. Elsewhere it is like the ground if another plane continues it at nearly its
 * height and slope, or lies far above the sample, as the slope over a terrace does. The
 * plane is ground if more than half as much of the outline is like the ground as like a
 * roof; what is like the ground for both reasons counts twice.
 * \param[in] plane an element of \p all, not a copy: it is recognized by its address */
bool
isPartOfGround (const PlaneFromAbove& plane, const std::vector<PlaneFromAbove>& all);

/** \brief Returns whether less than half of a plane has another plane below it, as the
 * ground has nothing below it. False for a plane without an outline.
 * \param[in] plane an element of \p all, as above
 * \param[in] min_drop planes less far below do not count, such as the next field of a
 * slope [m] */
bool
isLowest (const PlaneFromAbove& plane,
          const std::vector<PlaneFromAbove>& all,
          double min_drop);

} // namespace pcl_ops::internal::buildings
