// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/plane_extent.h>

namespace pcl_ops {

/** \brief Points in a plane whose hull is taken off layer by layer. Only those near the
 * hull are looked at in each step. */
class Rim {
public:
  /** \param[in] points finite ones */
  explicit Rim (PlanarPoints points) : inner_ (std::move (points)) {}

  /** \brief Removes the corners of a hull of the points, and what lies on them.
   * \return how many points that were */
  std::size_t
  takeOff (const PlanarPoints& hull);

  /** \brief The hull of the points that are left. */
  PlanarPoints
  hull () const;

private:
  void
  splitNear (const PlanarPoints& hull);

  /** \brief The points near the hull, and all others with the corners of their hull. */
  PlanarPoints outer_, inner_, inner_hull_;
};

} // namespace pcl_ops
