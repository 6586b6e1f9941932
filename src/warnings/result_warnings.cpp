// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "warnings/frame_warnings.h"
#include "warnings/plane_warnings.h"
#include "warnings/unassigned_points.h"
#include <pcl_ops/result_warnings.h>

#include <utility>

namespace pcl_ops {

std::vector<ResultWarning>
resultWarnings (const CloudView& cloud,
                const std::vector<PlaneSegment>& planes,
                const ResultContext& context)
{
  using namespace internal;
  const ParameterText text{context.names};
  const LabeledSample sample = sampleWithLabels (cloud, planes, context.shift);
  std::vector<ResultWarning> warnings;
  const auto add = [&] (std::optional<ResultWarning> warning) {
    if (warning && warnings.size() < context.max_warnings)
      warnings.push_back (*std::move (warning));
  };
  // Warnings about outputs that are wrong or empty as a whole come first.
  const std::optional<ResultWarning> unit_warning = warnOfUnit (sample, context, text);
  const std::optional<ResultWarning> plan_warning =
      warnOfEmptyPlan (context, unit_warning, text);
  // The warning of an empty plan contains that of the unit.
  add (plan_warning ? plan_warning : unit_warning);
  add (warnOfPrecision (sample, context));
  add (warnOfPoses (context, text));
  add (warnOfUp (sample, planes, context, text));
  add (warnOfViewpoint (cloud, context, text));
  const bool is_default_search = context.search || context.tiles;
  add (warnOfLevels (planes, is_default_search, text));
  add (warnOfThickPlanes (planes, context.tiles, text));
  if (context.search)
    add (warnOfUnassignedPoints (cloud, sample, planes, *context.search, text));
  if (context.tiles)
    add (warnOfUnassignedPoints (sample, *context.tiles, text));
  add (warnOfMixedLabels (sample, planes, context.tiles, text));
  return warnings;
}

} // namespace pcl_ops
