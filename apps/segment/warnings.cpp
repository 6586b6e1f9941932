// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "warnings.h"

#include <detection/warning_lines.h>

namespace pcl_ops::apps {

namespace {

/** \brief Whether the up axis is known, was estimated without success, or is assumed.
 */
UpKnowledge
knowledgeOfUp (const DetectorOptions& detector,
               const FileCloud& cloud,
               const Detected& detected)
{
  const bool is_estimated = detector.finds_up || detector.is_up_of_sequence_estimated;
  if (is_estimated)
    return detected.settings.at ("up_confidence").is_null() ? UpKnowledge::NotFound
                                                            : UpKnowledge::Known;
  // A survey is in a reference system, where z is up.
  const bool is_given = detector.up || detector.up_is_camera || cloud.is_survey;
  return is_given ? UpKnowledge::Known : UpKnowledge::Assumed;
}

} // namespace

std::vector<ResultWarning>
warningsOn (const SegmentOptions& options,
            const Task& task,
            const FileCloud& cloud,
            const ShiftedCloud& shifted,
            const Detected& detected)
{
  ResultContext context;
  context.shift = shifted.shift;
  context.unit = cloud.las ? coordinateUnitOf (*cloud.las) : CoordinateUnit::Unknown;
  context.has_meter = options.has_meter;
  const bool has_sensor_position = !cloud.origin.head<3>().isZero (0.0F);
  if (has_sensor_position)
    context.viewpoint = shifted.cloud->sensor_origin_.head<3>().cast<double>();
  context.up_knowledge = knowledgeOfUp (options.detector, cloud, detected);
  context.up = detected.up.cast<double>();
  context.suggested_up = detected.suggested_up;
  context.uses_kinds = !task.outputs.floor_plan.empty() || options.choice.namesKinds();
  context.has_camera_poses = options.track.has_camera_poses;
  context.search = detected.search_parameters;
  std::vector<ResultWarning> warnings =
      resultWarnings (*shifted.cloud, detected.planes, context);
  if (cloud.las)
    putWarningOnHeights (*cloud.las, warnings);
  return warnings;
}

} // namespace pcl_ops::apps
