// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "survey_warnings.h"

#include "dense_boxes.h"
#include <detection/plane_list.h>
#include <detection/warning_lines.h>
#include <pcl_ops/detect_planes.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

namespace pcl_ops::apps {

namespace {

/** \brief Returns the first input if it is a .las or .laz, else nullptr: its reference
 * system is that of all inputs, which share a frame. Points are not read: openLas would
 * decompress all of a .laz. */
std::shared_ptr<LasFile>
firstInputIfLas (const Plan& plan)
{
  const std::string& file = plan.inputs.front().file;
  return isLasName (file) ? std::make_shared<LasFile> (file) : nullptr;
}

CloudView
viewOf (const DenseBox& dense)
{
  constexpr std::size_t x_offset = 0;
  const std::vector<Eigen::Vector3f>& points = dense.points;
  return {points.data(), x_offset, sizeof (points[0]), points.size()};
}

/** \brief Returns the noise of the largest plane that is found in a box [m]; nothing if
 * no plane is found, or the plane has no noise. */
std::optional<double>
noiseOf (const DenseBox& dense)
{
  const std::vector<PlaneSegment> planes =
      detectPlanes (viewOf (dense), OrientedPointSamplingParameters());
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

/** \brief Sets the noise of each plane to the median of \ref noiseOf over the boxes
 * around its points. If these have no noise, it is the median over the boxes of all
 * planes; if none has, the plane gets no noise. */
void
setNoise (const std::vector<DenseBox>& boxes, std::vector<PlaneSegment>& planes)
{
  std::vector<double> all_noises;
  std::vector<std::vector<double>> noises_of_plane (planes.size());
  for (const DenseBox& dense : boxes)
    if (dense.group < planes.size()) // else around a point on no plane
      if (const std::optional<double> noise = noiseOf (dense)) {
        all_noises.push_back (*noise);
        noises_of_plane[dense.group].push_back (*noise);
      }
  const std::optional<double> usual = upperMedianOf (all_noises);
  for (std::size_t i = 0; i < planes.size(); ++i)
    planes[i].noise =
        noises_of_plane[i].empty() ? usual : upperMedianOf (noises_of_plane[i]);
}

/** \brief Returns what the library's warnings have to know of the tiles. */
TiledSearch
searchOf (const Plan& plan,
          const PlaneSample& sample,
          const std::vector<DenseBox>& boxes)
{
  TiledSearch search;
  search.voxel_size = plan.grid.edge;
  search.sampled_share =
      static_cast<double> (sample.shifted.cloud->size()) /
      static_cast<double> (std::max<std::uint64_t> (1, plan.points()));
  for (const DenseBox& dense : boxes)
    if (dense.group == sample.planes.size()) // around a point on no plane
      search.places_on_none.push_back (viewOf (dense));
  return search;
}

} // namespace

std::string
withWarnings (const Plan& plan,
              bool has_meter,
              const std::string& list_text,
              const ForEachLabeledPoint& for_each_point)
{
  // With so many points, shares of points are right within one percent.
  constexpr std::size_t sample_size = 40'000;
  auto list = nlohmann::ordered_json::parse (list_text);
  PlaneSample sample = samplePlanes (list, for_each_point, sample_size);
  const std::vector<DenseBox> boxes = denseBoxes (list, sample, for_each_point);
  setNoise (boxes, sample.planes);
  ResultContext context;
  context.shift = sample.shifted.shift;
  const std::shared_ptr<LasFile> las = firstInputIfLas (plan);
  context.unit = las ? coordinateUnitOf (*las) : CoordinateUnit::Unknown;
  context.has_meter = has_meter || plan.meter != 1.0;
  context.tiles = searchOf (plan, sample, boxes);
  std::vector<ResultWarning> warnings =
      resultWarnings (*sample.shifted.cloud, sample.planes, context);
  if (las)
    putWarningOnHeights (*las, warnings);
  if (warnings.empty())
    return list_text;
  // Keys stay in the order of insertion: the long list of planes comes last.
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
