// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "detection/labelled_planes.h"
#include "paper/oriented_points.h"
#include <pcl_ops/oriented_point_sampling.h>

#include <vector>

namespace pcl_ops::internal {

/** \brief The paper's Algorithm 1 on samples: one-point RANSAC, plane by plane.
 * \param[in] points all points, for Verification::AllPoints
 * \return planes in the order found */
std::vector<Plane>
extractPlanes (const Points& points,
               const OrientedSamples& samples,
               const OrientedPointSamplingParameters& parameters);

/** \brief The paper's sampling: points drawn at random, with the normals of their
 * nearest neighbors; planes do not end.
 * \param[in] input the cloud and, where there is one, the user's search
 * \param[in,out] durations what each stage took is added [ms] */
LabelledPlanes
detectAsInPaper (const DetectorInput& input,
                 const Points& points,
                 const OrientedPointSamplingParameters& parameters,
                 StageDurations& durations);

} // namespace pcl_ops::internal
