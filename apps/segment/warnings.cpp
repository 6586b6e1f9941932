// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "warnings.h"

#include <algorithm>

namespace pcl_ops::apps {

namespace {

/** \brief How sure the up axis is that was used. */
UpKnowledge
knowledgeOfUp (const DetectorOptions& detector,
               const FileCloud& cloud,
               const Detected& detected)
{
  if (detector.finds_up || detector.sequence_has_up)
    return detected.settings.at ("up_confidence").is_null() ? UpKnowledge::NotFound
                                                            : UpKnowledge::Known;
  // z is up in the reference systems of surveys.
  const bool is_said = detector.up || detector.up_is_camera || cloud.is_survey;
  return is_said ? UpKnowledge::Known : UpKnowledge::Assumed;
}

} // namespace

std::vector<ResultWarning>
warningsOn (const SegmentOptions& options,
            const FileCloud& cloud,
            const ShiftedCloud& shifted,
            const Detected& detected,
            bool has_camera_poses)
{
  ResultContext context;
  context.shift = shifted.shift;
  if (!cloud.origin.head<3>().isZero (0.0F))
    context.viewpoint = shifted.cloud->sensor_origin_.head<3>().cast<double>();
  context.has_meter = options.of_plan.meter != 1.0;
  context.up = knowledgeOfUp (options.detector, cloud, detected);
  context.uses_kinds = !options.outputs.plan.empty() || options.choice.namesKinds();
  context.has_camera_poses = has_camera_poses;
  return resultWarnings (*shifted.cloud, detected.planes, context);
}

std::size_t
wallsAmong (const Detected& detected)
{
  return static_cast<std::size_t> (
      std::count (detected.kinds.begin(), detected.kinds.end(), PlaneKind::Wall));
}

void
addWarningsOnPlan (std::size_t walls_found, Report& report)
{
  if (!report.plan)
    return;
  const std::vector<PlaneKind>& kinds = report.detected.kinds;
  ResultContext context;
  context.plan = PlanCounts{report.plan->walls.size(),
                            report.plan->rooms.size(),
                            walls_found,
                            wallsAmong (report.detected),
                            std::find (kinds.begin(), kinds.end(), PlaneKind::Floor) !=
                                kinds.end()};
  std::vector<ResultWarning> all = resultWarnings ({}, {}, context);
  all.insert (all.end(), report.warnings.begin(), report.warnings.end());
  all.resize (std::min (all.size(), context.max_warnings));
  report.warnings = std::move (all);
}

} // namespace pcl_ops::apps
