// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "survey_warnings.h"

#include "dense_places.h"
#include <detection/plane_list.h>
#include <detection/warning_lines.h>
#include <pcl_ops/detect_planes.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace pcl_ops::apps {

namespace {

/** \brief Unit of the first input's reference system; all inputs share a frame. */
CoordinateUnit
unitOfSurvey (const Plan& plan)
{
  const std::string& file = plan.inputs.front().file;
  if (!isLasName (file))
    return CoordinateUnit::Unknown;
  return coordinateUnitOf (*openLas (file));
}

CloudView
viewOf (const DensePlace& place)
{
  const std::vector<Eigen::Vector3f>& points = place.points;
  return {points.data(), 0, sizeof (Eigen::Vector3f), points.size()};
}

/** \brief The noise of the largest plane found in a place, if both exist. */
std::optional<double>
noiseOf (const DensePlace& place)
{
  const std::vector<PlaneSegment> planes =
      detectPlanes (viewOf (place), OrientedPointSamplingParameters());
  return planes.empty() ? std::nullopt : planes.front().noise;
}

std::optional<double>
upperMedianOf (std::vector<double> numbers)
{
  if (numbers.empty())
    return std::nullopt;
  const auto middle =
      numbers.begin() + static_cast<std::ptrdiff_t> (numbers.size() / 2);
  std::nth_element (numbers.begin(), middle, numbers.end());
  return *middle;
}

/** \brief Sets the noise of each plane to the median of the places on it, or of the
 * places on all planes if it has none. */
void
addNoise (const std::vector<DensePlace>& places, std::vector<PlaneSegment>& planes)
{
  std::vector<double> all;
  std::vector<std::vector<double>> of_planes (planes.size());
  for (const DensePlace& place : places)
    if (place.group < planes.size())
      if (const std::optional<double> noise = noiseOf (place)) {
        all.push_back (*noise);
        of_planes[place.group].push_back (*noise);
      }
  const std::optional<double> usual = upperMedianOf (all);
  for (std::size_t i = 0; i < planes.size(); ++i)
    planes[i].noise = of_planes[i].empty() ? usual : upperMedianOf (of_planes[i]);
}

TiledSearch
searchOf (const Plan& plan,
          const PlaneSample& sample,
          const std::vector<DensePlace>& places)
{
  TiledSearch search;
  search.voxel_size = plan.grid.edge;
  search.sampled_share =
      static_cast<double> (sample.shifted.cloud->size()) /
      static_cast<double> (std::max<std::uint64_t> (1, plan.points()));
  for (const DensePlace& place : places)
    if (place.group == sample.planes.size())
      search.places_on_none.push_back (viewOf (place));
  return search;
}

} // namespace

std::string
withWarnings (const Plan& plan,
              bool has_meter,
              const std::string& list_text,
              const LabelledPoints& points)
{
  // Enough points for shares of points to be right within one per cent.
  constexpr std::size_t looked_at = 40'000;
  auto list = nlohmann::ordered_json::parse (list_text);
  PlaneSample sample = samplePlanes (list, points, looked_at);
  const std::vector<DensePlace> places = densePlaces (list, sample, points);
  addNoise (places, sample.planes);
  ResultContext context;
  context.shift = sample.shifted.shift;
  context.unit = unitOfSurvey (plan);
  context.has_meter = has_meter || plan.meter != 1.0;
  context.tiles = searchOf (plan, sample, places);
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
