// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "warnings/labeled_sample.h"
#include "warnings/parameter_text.h"
#include <pcl_ops/oriented_point_sampling.h>
#include <pcl_ops/result_warnings.h>

#include <optional>
#include <vector>

namespace pcl_ops::internal {

/** \brief Warns that many points are on no plane although a search with another value
 * of a parameter puts them on planes. Clouds of more than 100,000 finite points are not
 * searched again, and get no warning.
 * \param[in] search the parameters that the planes were found with */
std::optional<ResultWarning>
warnOfUnassignedPoints (const CloudView& cloud,
                        const LabeledSample& sample,
                        const std::vector<PlaneSegment>& planes,
                        const OrientedPointSamplingParameters& search,
                        const ParameterText& text);

/** \brief The same for a survey: searches only the clouds of \ref
 * TiledSearch::places_on_none, with voxels of half the edge. */
std::optional<ResultWarning>
warnOfUnassignedPoints (const LabeledSample& sample,
                        const TiledSearch& tiles,
                        const ParameterText& text);

} // namespace pcl_ops::internal
