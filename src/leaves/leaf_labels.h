// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "leaves/leaf_cloud.h"

#include <optional>
#include <vector>

namespace pcl_ops::internal {

/** \brief Labels each point with the likeliest plane of the leaves around its own: the
 * least d^2 / sigma^2 + 2 ln sigma, sigma the noise of the plane there.
 * \param[in] noise_factor largest distance in units of that noise
 * \param[in] distance_threshold theta_h: largest distance [m], if any
 * \return of \ref LeafCloud::points, in their order */
Labels
labelPoints (const LeafCloud& cloud,
             const LeafPlanes& planes,
             double noise_factor,
             std::optional<double> distance_threshold,
             unsigned threads);

/** \brief How many points have each label. */
std::vector<std::size_t>
countLabels (const Labels& labels, std::size_t planes);

/** \brief The plane that the middle point of each leaf is on.
 * \param[in] labels of the points, in their order along the curve */
Labels
planesOfLeaves (const std::vector<Leaf>& leaves, const Labels& labels);

} // namespace pcl_ops::internal
