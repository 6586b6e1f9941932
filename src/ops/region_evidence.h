// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ops/regions.h"

#include <vector>

namespace pcl_ops::internal {

/** \brief What speaks for a region being a plane, and against it. */
struct RegionEvidence {
  /** \brief Decades of its points above the square root of all, where points err
   * independently. */
  double size = 0.0;
  /** \brief What a quadratic surface explains of its distances over what is left. */
  double bend = 0.0;
  /** \brief The share of its border where the next region goes on smoothly, times how
   * far that one bends: facets of what is round. */
  double smooth_border = 0.0;
  /** \brief The share of its border where no region goes on. */
  double open_border = 0.0;

  /** \brief Above 0 more speaks for it. */
  double
  sum () const;
};

/** \brief Which regions are planes: those with enough places for which more speaks than
 * against them. One sum is steadier than limits one after the other, which lose planes
 * that miss one of them by little. */
std::vector<char>
planesAmong (const Places& places,
             const PlaceNoise& noise,
             const ChosenSupports& chosen,
             const Regions& regions,
             double min_points_factor,
             unsigned threads);

} // namespace pcl_ops::internal
