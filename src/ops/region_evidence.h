// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ops/regions.h"

#include <vector>

namespace pcl_ops::internal {

/** \brief What speaks for a region being a plane, and against it. */
struct RegionEvidence {
  /** \brief Logarithm to base 10 of its points over the square root of all points of
   * the cloud; less where points err alike. */
  double size = 0.0;
  /** \brief How much of its distances a quadratic surface explains, over what is left:
   * a ratio of rms, 0 where it is flat. */
  double bend = 0.0;
  /** \brief The share of its border where the next region goes on smoothly, times the
   * bend of that one: high on the facets of what is round. */
  double smooth_border = 0.0;
  /** \brief The share of its border where no region goes on. */
  double open_border = 0.0;

  /** \brief Above 0 more speaks for a plane than against it. */
  double
  sum () const;
};

/** \brief Tells which regions are planes: those with enough places and a sum of
 * evidence above 0. One sum is steadier than limits one after the other, which lose
 * planes that miss one of them by little.
 * \param[in] min_points_factor how many times the usual number of points a plane needs
 * \return for each region 1 or 0 */
std::vector<char>
planesAmong (const Places& places,
             const PlaceNoise& noise,
             const ChosenSupports& chosen,
             const Regions& regions,
             double min_points_factor,
             unsigned threads);

} // namespace pcl_ops::internal
