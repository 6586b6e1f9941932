// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <evaluation/data/data_sets.h>

namespace pcl_ops::evaluation {

/** \brief True planes for clouds without labels (paper section IV-A), by region growing
 * from the flattest points on: a neighbor of a point joins its region if it is within 5
 * cm of the region's plane and both normals agree to 7 degrees. Regions of under 50
 * points are on no plane.
 * \param[in] cloud finite points
 * \param[in] neighbors of a point its normal comes from and its region may grow to
 * \return labels 1 .. P by falling size */
PlaneLabels
growRegions (const XyzCloud& cloud, int neighbors);

/** \brief Where the truth of a cloud comes from that has none. */
struct TruthParameters {
  /** \brief Of \ref growRegions. The paper does not say; on raw depth 30 leave many
   * points without a plane. */
  int neighbors = 100;
  /** \brief True planes with fewer points are none, whatever the truth's source. */
  std::size_t min_points = 50;
};

/** \brief The exact truth of a cloud, or else the one grown from it. */
PlaneLabels
truthOf (const EvaluationCloud& cloud, const TruthParameters& parameters);

/** \brief How the truth of a cloud was had: "exact", or "grown-k100" with its number of
 * neighbors. */
std::string
truthName (bool is_exact, const TruthParameters& parameters);

} // namespace pcl_ops::evaluation
