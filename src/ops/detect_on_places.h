// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "detection/labeled_planes.h"
#include <pcl_ops/oriented_point_sampling.h>

namespace pcl_ops::internal {

/** \brief Detects planes from the neighborhoods of places (distinct points); this is
 * the default. No voxel grid divides space: the planes hardly change if the cloud is
 * moved or rotated, or if some points are missing. Too few points have no planes and no
 * stages: see min_places and drawsNothing (place_parameters.h).
 * OrientedPointSamplingParameters::on_stage gets the results of all stages except
 * Stage::Labels, with a value for each of \p points.
 * \param[in,out] times the durations of the stages are added to it */
LabeledPlanes
detectOnPlaces (const Points& points,
                const OrientedPointSamplingParameters& parameters,
                StageDurations& times);

/** \brief Measures the noise of a cloud.
 * \param[in] points all points of the cloud, or all points of some parts of it
 * \param[in] points_of_whole number of points of the cloud if \p points are those of
 * parts; else 0
 * \return CloudNoise::points is 0 for fewer than min_places distinct points */
CloudNoise
noiseOfCloud (const Points& points,
              const OrientedPointSamplingParameters& parameters,
              std::size_t points_of_whole);

} // namespace pcl_ops::internal
