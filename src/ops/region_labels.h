// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ops/regions.h"

#include <optional>
#include <vector>

namespace pcl_ops::internal {

/** \brief Assigns each place to its likeliest plane. Candidates are the planes that are
 * near enough and whose regions contain the place or one of its neighbors. The
 * likeliest plane has the smallest d^2 / s^2 + 2 ln s, where d is the distance of the
 * place to the plane and s the noise of the plane around the place [m]: the scatter of
 * the region or the noise of the place, whichever is larger; that of the place counts
 * as at most max_noise_over_region times that of the region. But for a constant the sum
 * is -2 times the logarithm of the normal distribution of d. Without 2 ln s noisy
 * planes would take the points of clean ones.
 * \param[in] is_plane for each region, whether it is a plane
 * \param[in] distance_threshold largest distance of a place to its plane [m]; if not
 * given, it follows the noise
 * \return for each place the index of the region of its plane, or no_plane */
Labels
labelPlaces (const Places& places,
             const PlaceNoise& noise,
             const Regions& regions,
             const std::vector<char>& is_plane,
             std::optional<double> distance_threshold,
             unsigned threads);

} // namespace pcl_ops::internal
