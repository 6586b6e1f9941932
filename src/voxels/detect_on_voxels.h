// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "detection/labelled_planes.h"
#include <pcl_ops/oriented_point_sampling.h>

namespace pcl_ops::internal {

using SurfelParameters = OrientedPointSamplingParameters::Surfels;

/** \brief Edge of the largest voxels where their size is given; else 0. Voxels of a
 * given size begin at whole multiples of it in the frame of the input cloud, so that
 * parts of a cloud have the voxels of the whole. */
double
coarsestVoxel (const SurfelParameters& surfels);

/** \brief The recommended sampling: the flat voxels of a grid, with the normals of the
 * moments around; planes end where their voxels end. Coarse first: only points that no
 * plane explains are looked at in voxels of half the edge.
 * \param[in,out] durations what each stage took is added [ms] */
LabelledPlanes
detectOnVoxels (const Points& points,
                const OrientedPointSamplingParameters& parameters,
                StageDurations& durations);

} // namespace pcl_ops::internal
