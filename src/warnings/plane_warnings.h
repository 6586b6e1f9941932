// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "warnings/labeled_sample.h"
#include "warnings/parameter_text.h"
#include <pcl_ops/plane.h>
#include <pcl_ops/result_warnings.h>

#include <optional>
#include <vector>

namespace pcl_ops::internal {

// Warnings about the planes themselves. Each function returns one warning, or nothing.

/** \brief Warns that most points on planes are on thick planes, whose rms distance is
 * several times the noise around them. */
std::optional<ResultWarning>
warnOfThickPlanes (const std::vector<PlaneSegment>& planes,
                   const std::optional<TiledSearch>& tiles,
                   const ParameterText& text);

/** \brief Warns that planes of rms distance 0 lie one behind another, as the levels of
 * a depth image do.
 * \param[in] is_default_search whether the planes are of OPS on neighborhoods or of a
 * survey in tiles: for these a voxel size is advised, for others OPS without one */
std::optional<ResultWarning>
warnOfLevels (const std::vector<PlaneSegment>& planes,
              bool is_default_search,
              const ParameterText& text);

/** \brief Warns that neighboring points are on different planes that may be one
 * surface. */
std::optional<ResultWarning>
warnOfMixedLabels (const LabeledSample& sample,
                   const std::vector<PlaneSegment>& planes,
                   const std::optional<TiledSearch>& tiles,
                   const ParameterText& text);

} // namespace pcl_ops::internal
