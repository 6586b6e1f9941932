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

// What is doubtful about the frame and the unit of a result: each function says one
// thing, or nothing.

/** \brief Why a floor plan has no wall.
 * \param[in] on_unit what is said of the unit, which is the reason if there is any */
std::optional<ResultWarning>
warnOfEmptyPlan (const ResultContext& context,
                 const std::optional<ResultWarning>& on_unit,
                 const ParameterText& text);

/** \brief That poses are those of a camera and clouds are those of a lidar. */
std::optional<ResultWarning>
warnOfPoses (const ResultContext& context, const ParameterText& text);

/** \brief That coordinates are no meters. */
std::optional<ResultWarning>
warnOfUnit (const LabelledSample& sample,
            const ResultContext& context,
            const ParameterText& text);

/** \brief That coordinates in single precision are too far from zero to tell its points
 * apart, as those of UTM. */
std::optional<ResultWarning>
warnOfPrecision (const LabelledSample& sample, const ResultContext& context);

/** \brief That the cloud was not seen from where the sensor is said to have been. */
std::optional<ResultWarning>
warnOfViewpoint (const CloudView& cloud,
                 const ResultContext& context,
                 const ParameterText& text);

/** \brief That kinds of planes were asked for, and up is not known: planes cannot tell
 * it, or the default is doubtful. */
std::optional<ResultWarning>
warnOfUp (const LabelledSample& sample,
          const std::vector<PlaneSegment>& planes,
          const ResultContext& context,
          const ParameterText& text);

} // namespace pcl_ops::internal
