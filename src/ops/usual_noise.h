// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/detection_report.h>

#include <vector>

namespace pcl_ops::internal {

/** \brief The value below which a share of the values lies; 0 for no values. Reorders.
 */
float
quantileOf (std::vector<float>& values, double share);

/** \brief Sets CloudNoise::usual, and usual_of_octave for each doubling of the density.
 * \param[in] density of each place that tells its noise [1/m^2]
 * \param[in] noise of the same places [m] */
void
setUsualNoise (const std::vector<float>& density,
               const std::vector<float>& noise,
               CloudNoise& cloud);

/** \brief The median noise of places of a density [1/m^2], in meters; 0 where no place
 * tells. It is interpolated between the middles of octaves: a small change of the
 * density is a small change of the noise. */
double
usualNoise (const CloudNoise& cloud, double density);

} // namespace pcl_ops::internal
