// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud/points.h"

#include <cstddef>
#include <vector>

namespace pcl_ops::internal {

/** \brief The points around a place, as if they were a piece of a plane. */
struct Support {
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();
  /** \brief Rms distance of the points to their plane, as of independent ones [m]. */
  float scatter = 0.0F;
  /** \brief Extent in the narrower direction of the plane [m]. */
  float width = 0.0F;
  /** \brief Thin for its width, and no line. */
  bool is_flat = false;
};

/** \brief Points, each with those around it. Nothing here divides space: a neighborhood
 * is of one point, and another point more or less changes a neighborhood by one point.
 * What cells of a grid or of a tree hold changes altogether where their borders move.
 */
struct Places {
  /** \brief [m] in the local frame. */
  std::vector<Eigen::Vector3d> position;
  /** \brief So many of each, nearest first, without itself. */
  Indices nearest;
  std::size_t neighbors = 0;
  /** \brief Points per area around each [1/m^2]. */
  std::vector<float> density;
  /** \brief Of growing size: by level, then by place. */
  std::vector<std::vector<Support>> supports;
  /** \brief How many points a support of each level has. */
  std::vector<double> points_of_level;

  std::size_t
  size () const
  {
    return position.size();
  }

  /** \brief The first of the nearest ones of a place. */
  const std::uint32_t*
  nearestOf (std::size_t place) const
  {
    return nearest.data() + place * neighbors;
  }
};

/** \brief How many nearest points places of a cloud of so many points have, themselves
 * included. */
std::size_t
neighborsOfCloud (double points, double factor);

/** \brief Finds the nearest points of each point, and what the points around it are
 * like.
 *
 * The first support of a place is its nearest points. Each further one adds up the ones
 * before of the place and of eight places about twice as far away as the last time, so
 * that a level costs the same however many points it has.
 * \param[in] points four or more, no two at one place, in an order that depends on their
 * coordinates alone
 * \param[in] neighbors see \ref neighborsOfCloud */
Places
describePlaces (const Coordinates& points, std::size_t neighbors, unsigned threads);

} // namespace pcl_ops::internal
