// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ops/regions.h"

#include <vector>

namespace pcl_ops::internal {

/** \brief Evidence for and against a region being a plane. */
struct RegionEvidence {
  /** \brief Base 10 logarithm of the ratio of its points to the square root of the
   * number of points of the cloud. */
  double size = 0.0;
  /** \brief Rms height, above the plane of the region, of a quadratic surface fitted to
   * its places, divided by the rms of the residuals of this fit. It is 0 if the region
   * is flat or has fewer than 6 places, and at most PlaceConstants::max_bend. */
  double bend = 0.0;
  /** \brief Sum over the adjacent regions that continue the region smoothly: the share
   * of its border that touches flat places of them, times their bend. High for the
   * facets of a round surface. */
  double smooth_border = 0.0;
  /** \brief Share of its border beyond which there is no region, or only one with fewer
   * than 12 places. */
  double open_border = 0.0;

  /** \brief Returns the weighted sum of the evidence; above 0 the region is a plane. */
  double
  sum () const;
};

/** \brief Tells which regions are planes: those with enough places, enough flat places
 * and a sum of evidence above 0. With several limits instead of the sum, a plane that
 * misses one of them by little would be lost.
 * \param[in] min_points_factor multiplies the least number of places of a plane
 * \return for each region 1 if it is a plane, else 0 */
std::vector<char>
planesAmong (const Places& places,
             const PlaceNoise& noise,
             const ChosenSupports& chosen,
             const Regions& regions,
             double min_points_factor,
             unsigned threads);

} // namespace pcl_ops::internal
