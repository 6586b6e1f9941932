// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ops/regions.h"

#include <optional>
#include <vector>

namespace pcl_ops::internal {

/** \brief Gives each place to the likeliest of the planes whose regions it or one of
 * its neighbors is in: the one with the smallest d^2 / s^2 + 2 ln s, for a distance d
 * to a plane of noise s. Without the logarithm noisy planes would take the points of
 * clean ones.
 * \param[in] is_plane for each region, whether it is one of the planes
 * \param[in] distance_threshold largest distance [m]; where it is not given, the noise
 * limits it
 * \return for each place its region, or no_plane */
Labels
labelPlaces (const Places& places,
             const PlaceNoise& noise,
             const Regions& regions,
             const std::vector<char>& is_plane,
             std::optional<double> distance_threshold,
             unsigned threads);

} // namespace pcl_ops::internal
