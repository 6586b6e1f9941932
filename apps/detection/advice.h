// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <io/shifted_cloud.h>
#include <pcl_ops/fast_sampling_plane_filtering.h>
#include <pcl_ops/kernel_hough_transform.h>
#include <pcl_ops/oriented_point_sampling.h>
#include <pcl_ops/plane.h>

#include <string>
#include <vector>

namespace pcl_ops::apps {

/** \brief Whether so few of the points with coordinates are on planes that most likely
 * a parameter does not fit the cloud; also if there are no such points. */
bool
isHardlyCovered (const XyzCloud& cloud, const std::vector<PlaneSegment>& planes);

/** \brief Which parameter to change where a detector found no plane or, as \ref
 * isHardlyCovered says, next to none, as the end of a sentence. Looks at how the
 * threshold relates to the cloud's extent, which tells millimeters from meters, and,
 * for OPS, at how many points are sampled, for FSPF at how many points its spheres
 * hold. */
std::string
adviceFor (const OrientedPointSamplingParameters& parameters,
           const XyzCloud& cloud,
           bool found_none);
std::string
adviceFor (const FastSamplingPlaneFilteringParameters& parameters,
           const XyzCloud& cloud,
           bool found_none);
std::string
adviceFor (const KernelHoughTransformParameters& parameters,
           const XyzCloud& cloud,
           bool found_none);

} // namespace pcl_ops::apps
