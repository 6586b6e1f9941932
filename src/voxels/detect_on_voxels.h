// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "detection/labeled_planes.h"
#include <pcl_ops/oriented_point_sampling.h>

namespace pcl_ops::internal {

using SurfelParameters = OrientedPointSamplingParameters::Surfels;

/** \brief Edge of the voxels of the coarsest resolution [m] if the voxel size is given;
 * else 0. The origin of Points has to be a multiple of this edge. Then voxels of a
 * given size begin at whole multiples of their edge in the frame of the input cloud, so
 * that parts of a cloud have the voxels of the whole. */
double
coarsestVoxel (const SurfelParameters& surfels);

/** \brief Detects planes by Sampling::Surfels. The samples are the flat voxels of a
 * grid, with normals from the moments around them; planes end where their voxels end.
 * Points that no plane explains are searched again, in voxels of half the edge.
 * \param[in,out] durations the time of each stage is added [ms] */
LabeledPlanes
detectOnVoxels (const Points& points,
                const OrientedPointSamplingParameters& parameters,
                StageDurations& durations);

} // namespace pcl_ops::internal
