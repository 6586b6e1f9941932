// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/plane_extent.h>

namespace pcl_ops::internal {

/** \brief The convex hull of all points.
 * \param[in] points finite ones
 * \return counter-clockwise, the first corner not repeated; empty where the points span
 * no area */
PlanarPoints
hullOfAll (const PlanarPoints& points);

/** \brief Points in a plane, taken off from outside. Those clearly inside are not
 * looked at again. */
class Rim {
public:
  /** \param[in] points finite ones */
  explicit Rim (const PlanarPoints& points);

  /** \brief The hull of the points that are left. */
  PlanarPoints
  hull () const;

  /** \brief Removes all points on the hull and those nearest to it.
   * \param[in] hull of the points that are left
   * \param[in] fewest how many points to remove at least
   * \return how many points that were */
  std::size_t
  takeOff (const PlanarPoints& hull, std::size_t fewest);

private:
  PlanarPoints outer_;
  /** \brief Points around all others; they stay. */
  PlanarPoints inner_hull_;
};

} // namespace pcl_ops::internal
