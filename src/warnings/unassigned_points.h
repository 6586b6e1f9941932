// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "warnings/labelled_sample.h"
#include "warnings/parameter_text.h"
#include <pcl_ops/oriented_point_sampling.h>
#include <pcl_ops/result_warnings.h>

#include <optional>
#include <vector>

namespace pcl_ops::internal {

/** \brief That many points are on no plane which another value of a parameter puts on
 * planes: a second search tells, of clouds that are not too large for it. */
std::optional<ResultWarning>
warnOfUnassignedPoints (const CloudView& cloud,
                        const LabelledSample& sample,
                        const std::vector<PlaneSegment>& planes,
                        const OrientedPointSamplingParameters& search,
                        const ParameterText& text);

/** \brief The same of a survey: smaller voxels put points of places on none on planes.
 */
std::optional<ResultWarning>
warnOfUnassignedPoints (const LabelledSample& sample,
                        const TiledSearch& tiles,
                        const ParameterText& text);

} // namespace pcl_ops::internal
