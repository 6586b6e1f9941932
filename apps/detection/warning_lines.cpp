// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "warning_lines.h"

#include <algorithm>
#include <utility>

namespace pcl_ops::apps {

void
WarningLines::add (const std::string& input, const std::vector<ResultWarning>& warnings)
{
  for (const ResultWarning& warning : warnings) {
    auto line = std::find_if (lines_.begin(), lines_.end(), [&] (const Line& known) {
      return known.warning.code == warning.code;
    });
    if (line == lines_.end())
      line = lines_.insert (line, {warning, input});
    ++line->input_count;
  }
}

std::vector<std::string>
WarningLines::lines() const
{
  std::vector<Line> sorted = lines_;
  std::stable_sort (
      sorted.begin(), sorted.end(), [] (const Line& one, const Line& other) {
        return one.input_count > other.input_count;
      });
  sorted.resize (std::min (sorted.size(), ResultContext().max_warnings));
  std::vector<std::string> lines;
  for (const Line& line : sorted) {
    const std::size_t other_inputs = line.input_count - 1;
    lines.push_back (line.first_input +
                     (other_inputs == 0 ? ""
                      : other_inputs == 1
                          ? " and 1 other"
                          : " and " + std::to_string (other_inputs) + " others") +
                     ": " + line.warning.text);
  }
  return lines;
}

void
putWarningOnPlan (const PlanCounts& counts,
                  bool is_in_tiles,
                  std::vector<ResultWarning>& warnings)
{
  ResultContext context;
  if (is_in_tiles)
    context.tiles.emplace();
  context.plan = counts;
  // As cloud and planes are empty, only the floor plan can give a warning.
  std::vector<ResultWarning> plan_first = resultWarnings ({}, {}, context);
  if (plan_first.empty())
    return;
  for (const ResultWarning& warning : warnings) {
    const bool is_on_unit = warning.code == "millimeters" || warning.code == "feet" ||
                            warning.code == "degrees";
    if (!is_on_unit) {
      plan_first.push_back (warning);
      continue;
    }
    // "what is doubtful: the reason"
    std::string& text = plan_first.front().text;
    text = text.substr (0, text.find (": ") + 2) + warning.text;
  }
  plan_first.resize (std::min (plan_first.size(), context.max_warnings));
  warnings = std::move (plan_first);
}

void
putWarningOnHeights (LasFile& las, std::vector<ResultWarning>& warnings)
{
  const LasUnit horizontal = unitOf (las), vertical = heightUnitOf (las);
  const bool is_only_z_in_feet =
      horizontal == LasUnit::Meter && vertical == LasUnit::Foot;
  const bool is_only_z_in_meters =
      horizontal == LasUnit::Foot && vertical == LasUnit::Meter;
  if (!is_only_z_in_feet && !is_only_z_in_meters)
    return;
  warnings.insert (
      warnings.begin(),
      ResultWarning{
          "height-unit",
          is_only_z_in_feet
              ? "by the reference system of the file x and y are in meters and z is in "
                "feet: slopes and distances mix both; convert z to meters"
              : "by the reference system of the file x and y are in feet and z is in "
                "meters: slopes and distances mix both; convert z to feet"});
  warnings.resize (std::min (warnings.size(), ResultContext().max_warnings));
}

CoordinateUnit
coordinateUnitOf (LasFile& las)
{
  switch (unitOf (las)) {
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

nlohmann::ordered_json
warningsToJson (const std::vector<ResultWarning>& warnings)
{
  auto array = nlohmann::ordered_json::array();
  for (const ResultWarning& warning : warnings)
    array.push_back ({{"code", warning.code}, {"text", warning.text}});
  return array;
}

} // namespace pcl_ops::apps
