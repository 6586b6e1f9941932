// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "detection/labelled_planes.h"
#include <pcl_ops/oriented_point_sampling.h>

namespace pcl_ops::internal {

/** \brief The default: planes from the neighborhoods of points. Nothing in it divides
 * space, and no decision is one of the whole cloud, so that its planes stay the same
 * where the cloud is moved or turned, and nearly the same where points are left out.
 * OrientedPointSamplingParameters::on_stage gets all stages but the last, as of \p
 * points. */
LabelledPlanes
detectOnPlaces (const Points& points,
                const OrientedPointSamplingParameters& parameters,
                StageDurations& times);

/** \brief The noise of a cloud, or of a sample of one of so many points; no points
 * where there are too few to tell. */
CloudNoise
noiseOfCloud (const Points& points,
              const OrientedPointSamplingParameters& parameters,
              std::size_t points_of_whole);

} // namespace pcl_ops::internal
