// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "leaves/leaf_surfels.h"

#include <vector>

namespace pcl_ops::internal {

/** \brief Planes of fewer points are not kept. */
constexpr std::size_t min_points_of_plane = 10;

/** \brief How a plane ends, counted in pairs of touching leaves of which one is its
 * own. A plane ends at a crease or in the air; a facet of something curved goes on
 * smoothly beyond its border: what lies there is near, and turned by no more than the
 * facet itself bends. */
struct PlaneBorder {
  double links = 0.0;
  double goes_on = 0.0;
  double ends = 0.0;
  /** \brief What lies beyond has no surface: leaves of vegetation, or of a tight bend.
   */
  double shapeless = 0.0;
  /** \brief Leaves that touch none of others. */
  double inner_leaves = 0.0;
};

/** \brief A plane as evidence has it, or two planes as if they were one. */
struct PlaneParts {
  std::int32_t number = no_plane;
  Plane plane = {};
  Moments moments = {};
  /** \brief All leaves, in ascending order. */
  Indices leaves = {};
  /** \brief Those that touched leaves of others when the parts were made. What planes
   * are joined never adds to them. */
  Indices border_leaves = {};
  /** \brief The number of the other of two planes. */
  std::int32_t other_number = no_plane;

  bool
  has (std::int32_t plane_of_leaf) const
  {
    return plane_of_leaf != no_plane &&
           (plane_of_leaf == number || plane_of_leaf == other_number);
  }
};

/** \brief The leaves and moments of each plane; planes without leaves have none. */
std::vector<PlaneParts>
partsOfPlanes (const LeafCloud& cloud, const LeafPlanes& planes);

/** \brief What speaks for a plane less what speaks against it; a plane is kept where
 * more speaks for it.
 *
 * Against a plane speak its bend over its noise, and the shares of its border where it
 * goes on smoothly and where what lies beyond has no surface; for it its size, the
 * share of its border where it ends, and the share of its leaves that are inside. Tests
 * one after the other lose planes that fail one of them by little.
 * \param[in] planes where the leaves of \p own have one of its numbers
 * \param[in] surfels of leaves without a plane */
double
evidenceOf (const LeafCloud& cloud,
            const LeafPlanes& planes,
            const std::vector<LeafSurfel>& surfels,
            const PlaneParts& own);

/** \brief Which planes are kept: those with enough points for which more speaks than
 * against them (\ref evidenceOf).
 * \param[in] points of each plane */
std::vector<char>
keptPlanes (const LeafCloud& cloud,
            const LeafPlanes& planes,
            const std::vector<LeafSurfel>& surfels,
            const std::vector<std::size_t>& points);

} // namespace pcl_ops::internal
