// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "detection/labelled_planes.h"
#include "kht/hough_planes.h"
#include "kht/octree_clusters.h"
#include <pcl_ops/kernel_hough_transform.h>

#include <vector>

namespace pcl_ops::internal {

/** \brief Assignment and merging of planes without bounds: \ref assignPoints, block by
 * block of the octree, where most planes are far away, and \ref mergePlanes.
 * \param[in] points the points
 * \param[in] found their clusters
 * \param[in] planes planes in the frame of the points
 * \param[in] parameters thresholds, the rule and the number of threads
 * \param[in,out] durations of assignment and merging */
LabelledPlanes
assignToUnboundedPlanes (const Points& points,
                         const OctreeClusters& found,
                         const std::vector<HoughPlane>& planes,
                         const KernelHoughTransformParameters& parameters,
                         StageDurations& durations);

/** \brief The same with planes that support what their clusters cover and what they
 * grow into: merging first, on the voxels of a grid, and then \ref
 * assignToBoundedPlanes of voxels. */
LabelledPlanes
assignToOutlinedPlanes (const Points& points,
                        const OctreeClusters& found,
                        const std::vector<HoughPlane>& planes,
                        const KernelHoughTransformParameters& parameters,
                        StageDurations& durations);

} // namespace pcl_ops::internal
