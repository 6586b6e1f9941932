// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "detection/labelled_planes.h"
#include <pcl_ops/oriented_point_sampling.h>

namespace pcl_ops::internal {

/** \brief The default: planes from the neighborhoods of places, which are the distinct
 * points. It uses no grid of voxels, so that planes stay the same where the cloud is
 * moved or turned, and nearly the same where points are left out.
 * OrientedPointSamplingParameters::on_stage gets the results of all stages but the
 * last, with a value for each of \p points. */
LabelledPlanes
detectOnPlaces (const Points& points,
                const OrientedPointSamplingParameters& parameters,
                StageDurations& times);

/** \brief Measures the noise of a cloud. Where it cannot tell, as of few points,
 * CloudNoise::points of the result is 0.
 * \param[in] points all of the cloud, or all of some of its parts
 * \param[in] points_of_whole how many the cloud has, if they are of parts; else 0 */
CloudNoise
noiseOfCloud (const Points& points,
              const OrientedPointSamplingParameters& parameters,
              std::size_t points_of_whole);

} // namespace pcl_ops::internal
