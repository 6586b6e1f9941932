// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "survey_warnings.h"

#include <detection/plane_list.h>
#include <detection/warning_lines.h>
#include <io/las_unit.h>

#include <utility>

namespace pcl_ops::apps {

namespace {

/** \brief By the reference system of the first input; all have the same frame. */
CoordinateUnit
unitOfSurvey (const Plan& plan)
{
  const std::string& file = plan.inputs.front().file;
  if (!isLasName (file))
    return CoordinateUnit::Unknown;
  switch (unitOf (*openLas (file))) {
  case LasUnit::Meter:
    return CoordinateUnit::Meter;
  case LasUnit::Foot:
    return CoordinateUnit::Foot;
  case LasUnit::Degree:
    return CoordinateUnit::Degree;
  case LasUnit::Unknown:
    break;
  }
  return CoordinateUnit::Unknown;
}

} // namespace

std::string
withWarnings (const Plan& plan,
              bool has_meter,
              const std::string& list_text,
              const LabelledPoints& points)
{
  // Enough for a share to be right within one per cent.
  constexpr std::size_t looked_at = 40'000;
  auto list = nlohmann::ordered_json::parse (list_text);
  const PlaneSample sample = samplePlanes (list, points, looked_at);
  ResultContext context;
  context.shift = sample.shifted.shift;
  context.unit = unitOfSurvey (plan);
  context.has_meter = has_meter || plan.meter != 1.0;
  const std::vector<ResultWarning> warnings =
      resultWarnings (*sample.shifted.cloud, sample.planes, context);
  if (warnings.empty())
    return list_text;
  nlohmann::ordered_json planes = std::move (list.at ("planes"));
  list.erase ("planes");
  list["warnings"] = warningsToJson (warnings);
  list["planes"] = std::move (planes);
  return jsonText (list);
}

std::vector<ResultWarning>
warningsIn (const nlohmann::ordered_json& list)
{
  std::vector<ResultWarning> warnings;
  if (list.contains ("warnings"))
    for (const auto& warning : list.at ("warnings"))
      warnings.push_back ({warning.at ("code"), warning.at ("text")});
  return warnings;
}

} // namespace pcl_ops::apps
