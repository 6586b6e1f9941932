// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/detection_report.h>

#include <vector>

namespace pcl_ops::internal {

/** \brief Returns a quantile of values; 0 if there are none.
 * \param[in,out] values get reordered
 * \param[in] share of the values below the quantile, 0 to 1; 0.5: the median */
float
quantileOf (std::vector<float>& values, double share);

/** \brief Sets CloudNoise::usual to the median noise, and usual_of_octave to that of
 * each octave of the density: octave n has the densities from 2^n on, below 2^(n + 1).
 * Noise in the adjacent octaves counts, too, with half the weight. The median of an
 * octave is at most PlaceConstants::max_usual_over_cloud times that of the cloud.
 * \param[in] density of each place whose noise is known [1/m^2]
 * \param[in] noise of the same places [m] */
void
setUsualNoise (const std::vector<float>& density,
               const std::vector<float>& noise,
               CloudNoise& cloud);

/** \brief Returns the median noise [m] of places with a density [1/m^2]. It is
 * interpolated between the middles of two octaves, so that a small change of the
 * density changes it little. If only one octave has a value, it is that one; if neither
 * has, CloudNoise::usual. */
double
usualNoise (const CloudNoise& cloud, double density);

} // namespace pcl_ops::internal
