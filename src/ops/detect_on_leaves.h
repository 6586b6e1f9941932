// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "detection/labelled_planes.h"
#include <pcl_ops/oriented_point_sampling.h>

namespace pcl_ops::internal {

/** \brief OPS on leaves of an octree: planes as thin as the noise of their
 * surroundings, in leaves of mixed sizes, with one graph, one label a leaf and one list
 * of planes. With Sampling::Automatic on voxels where noise is uneven. */
LabelledPlanes
detectOnLeaves (const Points& points,
                const OrientedPointSamplingParameters& parameters,
                StageDurations& times);

} // namespace pcl_ops::internal
