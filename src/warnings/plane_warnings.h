// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "warnings/labelled_sample.h"
#include "warnings/parameter_text.h"
#include <pcl_ops/plane.h>
#include <pcl_ops/result_warnings.h>

#include <optional>
#include <vector>

namespace pcl_ops::internal {

// What is doubtful about planes by themselves: each function says one thing, or
// nothing.

/** \brief That much is on planes whose rms is several times the noise around them. */
std::optional<ResultWarning>
warnOfThickPlanes (const std::vector<PlaneSegment>& planes,
                   const std::optional<TiledSearch>& tiles,
                   const ParameterText& text);

/** \brief That planes of rms 0 lie one behind another, as levels of a depth image do.
 * \param[in] is_default_search whether the engine found them that looks for levels, or
 * there is no other */
std::optional<ResultWarning>
warnOfLevels (const std::vector<PlaneSegment>& planes,
              bool is_default_search,
              const ParameterText& text);

/** \brief That points side by side are on different planes that may be one surface. */
std::optional<ResultWarning>
warnOfMixedLabels (const LabelledSample& sample,
                   const std::vector<PlaneSegment>& planes,
                   const std::optional<TiledSearch>& tiles,
                   const ParameterText& text);

} // namespace pcl_ops::internal
