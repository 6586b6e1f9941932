// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "detection/labeled_planes.h"
#include "paper/oriented_points.h"
#include <pcl_ops/oriented_point_sampling.h>

#include <vector>

namespace pcl_ops::internal {

/** \brief Finds planes in oriented samples by one-point RANSAC, one after the other
 * (the paper's Algorithm 1). Strategy 2 (DivideThenDetect) searches horizontal,
 * vertical and other samples separately.
 * \param[in] parameters with a distance_threshold
 * \param[in] points all finite points; only Verification::AllPoints uses them
 * \return the planes in the order they were found */
std::vector<Plane>
extractPlanes (const Points& points,
               const OrientedSamples& samples,
               const OrientedPointSamplingParameters& parameters);

/** \brief The detector of Sampling::Points: draws points at random, estimates their
 * normals from the nearest neighbors, extracts planes by \ref extractPlanes, assigns
 * all points to these unbounded planes, and merges the planes.
 * \param[in] input the cloud, and the user's neighbor search if one is set
 * \param[in] points all finite points of the cloud
 * \param[in] parameters with a distance_threshold
 * \param[in,out] durations to which the wall time of each stage is added [ms] */
LabeledPlanes
detectAsInPaper (const DetectorInput& input,
                 const Points& points,
                 const OrientedPointSamplingParameters& parameters,
                 StageDurations& durations);

} // namespace pcl_ops::internal
