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
atPlaces (const std::vector<Value>& of_places, const Indices& place_of_point)
{
  if (of_places.empty())
    return {};
  std::vector<Value> of_points;
  of_points.reserve (place_of_point.size());
  for (const std::uint32_t place : place_of_point)
    of_points.push_back (of_places[place]);
  return of_points;
}

// Returns a value for each point of the input cloud: copies have that of their point,
// points that were left out have \p unknown. Empty if there are no values.
template <typename Value>
std::vector<Value>
inCloud (const std::vector<Value>& of_points,
         const Points& points,
         std::size_t size_of_cloud,
         Value unknown)
{
  if (of_points.empty())
    return {};
  std::vector<Value> of_cloud (size_of_cloud, unknown);
  for (std::size_t i = 0; i < of_points.size(); ++i)
    of_cloud[points.indexOf (i)] = of_points[i];
  for (const Copy& copy : points.copies)
    of_cloud[copy.index] = of_points[copy.point];
  return of_cloud;
}

} // namespace

void
StageReports::operator() (Stage stage,
                          const std::vector<float>& values,
                          const std::vector<char>& is_flat) const
{
  if (!observer_)
    return;
  StageResult result{stage, atPlaces (values, place_of_point_)};
  for (const char flat : atPlaces (is_flat, place_of_point_))
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
  StageResult result{stage, {}, atPlaces (labels, place_of_point_)};
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
               inCloud (result.values, points, size_of_cloud, unknown),
               inCloud (result.labels, points, size_of_cloud, no_plane)});
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
