// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ops/stage_reports.h"

#include <limits>

namespace pcl_ops {

namespace internal {
namespace {

// Returns for each point the value of its place; empty if there are no values.
template <typename Value>
std::vector<Value>
valuesOfPoints (const std::vector<Value>& values_of_places,
                const Indices& place_of_point)
{
  if (values_of_places.empty())
    return {};
  std::vector<Value> values_of_points;
  values_of_points.reserve (place_of_point.size());
  for (const std::uint32_t place : place_of_point)
    values_of_points.push_back (values_of_places[place]);
  return values_of_points;
}

// Returns a value for each point of the input cloud. Duplicates (Points::copies) get
// the value of the point that represents them; points that the detector does not use
// get unknown. Empty if there are no values.
template <typename Value>
std::vector<Value>
valuesInCloud (const std::vector<Value>& values_of_points,
               const Points& points,
               std::size_t size_of_cloud,
               Value unknown)
{
  if (values_of_points.empty())
    return {};
  std::vector<Value> values_in_cloud (size_of_cloud, unknown);
  for (std::size_t i = 0; i < values_of_points.size(); ++i)
    values_in_cloud[points.indexOf (i)] = values_of_points[i];
  for (const Copy& copy : points.copies)
    values_in_cloud[copy.index] = values_of_points[copy.point];
  return values_in_cloud;
}

} // namespace

void
StageReports::operator() (Stage stage,
                          const std::vector<float>& values,
                          const std::vector<char>& is_flat) const
{
  if (!observer_)
    return;
  StageResult result{stage, valuesOfPoints (values, place_of_point_)};
  for (const char flat : valuesOfPoints (is_flat, place_of_point_))
    result.labels.push_back (flat != 0 ? 0 : no_plane);
  observer_ (result);
}

void
StageReports::operator() (Stage stage,
                          const Labels& labels,
                          const std::vector<char>& is_kept) const
{
  if (!observer_)
    return;
  StageResult result{stage, {}, valuesOfPoints (labels, place_of_point_)};
  if (!is_kept.empty())
    for (std::int32_t& label : result.labels)
      if (label != no_plane && is_kept[label] == 0)
        label = no_plane;
  observer_ (result);
}

StageObserver
observerOfPoints (const StageObserver& observer,
                  const Points& points,
                  std::size_t size_of_cloud)
{
  if (!observer)
    return {};
  return [&observer, &points, size_of_cloud] (const StageResult& result) {
    constexpr float unknown = std::numeric_limits<float>::quiet_NaN();
    observer ({result.stage,
               valuesInCloud (result.values, points, size_of_cloud, unknown),
               valuesInCloud (result.labels, points, size_of_cloud, no_plane)});
  };
}

void
reportLabels (const StageObserver& observer,
              const std::vector<PlaneSegment>& planes,
              std::size_t size_of_cloud)
{
  if (!observer)
    return;
  StageResult result{Stage::Labels, {}, Labels (size_of_cloud, no_plane)};
  for (std::size_t p = 0; p < planes.size(); ++p)
    for (const pcl::index_t index : planes[p].inliers)
      result.labels[index] = static_cast<std::int32_t> (p);
  observer (result);
}

} // namespace internal

const char*
toString (Stage stage)
{
  constexpr const char* names[] = {
      "density", "noise", "supports", "regions", "joined", "planes", "labels"};
  return names[static_cast<std::size_t> (stage)];
}

} // namespace pcl_ops
