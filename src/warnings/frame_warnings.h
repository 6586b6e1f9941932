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

// Warnings about the frame and the unit of a result, and about what depends on these.
// Each function returns one warning, or nothing.

/** \brief Warns that a floor plan has no walls, and gives the reason.
 * \param[in] unit_warning the result of \ref warnOfUnit; if there is one, it is the
 * reason */
std::optional<ResultWarning>
warnOfEmptyPlan (const ResultContext& context,
                 const std::optional<ResultWarning>& unit_warning,
                 const ParameterText& text);

/** \brief Warns that the poses of the frames look like those of KITTI's camera but are
 * used as those of its lidar. */
std::optional<ResultWarning>
warnOfPoses (const ResultContext& context, const ParameterText& text);

/** \brief Warns that the coordinates are not meters: degrees, feet or millimeters. */
std::optional<ResultWarning>
warnOfUnit (const LabeledSample& sample,
            const ResultContext& context,
            const ParameterText& text);

/** \brief Warns that coordinates are so far from zero, as in UTM, that single precision
 * hardly tells neighboring points apart. */
std::optional<ResultWarning>
warnOfPrecision (const LabeledSample& sample, const ResultContext& context);

/** \brief Warns that the cloud was not seen from the given viewpoint. */
std::optional<ResultWarning>
warnOfViewpoint (const CloudView& cloud,
                 const ResultContext& context,
                 const ParameterText& text);

/** \brief Warns that kinds of planes were asked for but the up axis is not known: the
 * planes cannot tell it, or the default is doubtful. */
std::optional<ResultWarning>
warnOfUp (const LabeledSample& sample,
          const std::vector<PlaneSegment>& planes,
          const ResultContext& context,
          const ParameterText& text);

} // namespace pcl_ops::internal
