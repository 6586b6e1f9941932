// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "leaves/leaf_cloud.h"

#include <vector>

namespace pcl_ops::internal {

/** \brief A flat surrounding that the points of a leaf lie on. */
struct LeafSurfel {
  Plane plane;
  /** \brief RMS distance of the points around to it [m]. */
  double noise = 0.0;
  /** \brief Noise over the spread in the narrow direction: 0 for an exact plane; 1:
   * there is none. */
  double thickness = 1.0;

  bool
  exists () const
  {
    return thickness < 1.0;
  }
};

struct LeafSurfelParameters {
  /** \brief Fewest points a normal comes from. */
  double min_points = 0.0;
  /** \brief How many rings of leaves are looked at. */
  int rings = 0;
};

/** \brief For each leaf without a plane the flattest surrounding that its points lie
 * on, of the smallest ring that has one flat enough: its own, or that of a leaf next to
 * it, which keeps surroundings from reaching over an edge. Rings are sums of moments:
 * ring 0 is a leaf and those that touch it, ring r the sum of rings r - 1 around. */
std::vector<LeafSurfel>
orientLeaves (const LeafCloud& cloud,
              const LeafPlanes& planes,
              const LeafSurfelParameters& parameters,
              unsigned threads);

} // namespace pcl_ops::internal
