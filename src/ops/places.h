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
  /** \brief Rms distance of the points to their plane [m], corrected for its three
   * parameters. */
  float scatter = 0.0F;
  /** \brief Extent in the narrower direction of the plane [m]. */
  float width = 0.0F;
  /** \brief Thin for its width, and no line: limits in ops/constants.h. */
  bool is_flat = false;
};

/** \brief Points, each with those around it. Nothing here divides space: a neighborhood
 * belongs to one point, and a point more or less changes it by one point only. Cells of
 * a grid or a tree would hold altogether different points where their borders move. */
struct Places {
  /** \brief [m] in the local frame. */
  std::vector<Eigen::Vector3d> position;
  /** \brief The nearest places of each place, itself left out, the nearest first: so
   * many of the first place, then of the second one, and so on. */
  Indices nearest;
  std::size_t neighbors = 0;
  /** \brief Points around each over the square of their width [1/m^2]. */
  std::vector<float> density;
  /** \brief supports[level][place], of growing size. */
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

/** \brief How many points neighborhoods have in a cloud of so many, their places
 * included.
 * \param[in] factor what parameters ask for, over what is usual */
std::size_t
neighborsOfCloud (double points, double factor);

/** \brief Finds the nearest points of each point, and what the points around it are
 * like.
 *
 * The first support of a place is its nearest points. Each further one adds up the
 * supports of the level before of the place and of eight places, its arms, which from
 * level to level are about twice as far away: a level costs the same however many
 * points it has.
 * \param[in] points least_places or more, no two at one place, in an order that depends on their
 * coordinates alone
 * \param[in] neighbors see \ref neighborsOfCloud */
Places
describePlaces (const Coordinates& points, std::size_t neighbors, unsigned threads);

} // namespace pcl_ops::internal
