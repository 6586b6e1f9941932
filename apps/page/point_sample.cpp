// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "point_sample.h"

#include <io/shifted_cloud.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pcl_ops::apps {

PointSample::PointSample (const std::vector<std::size_t>& sizes, std::size_t max_points)
: groups_ (sizes.size())
{
  // The least number of points of a group, chosen by hand: it shows where a plane is.
  constexpr std::size_t wanted_quota = 100;
  const std::size_t all = std::accumulate (sizes.begin(), sizes.end(), std::size_t (0));
  std::size_t min_quota = 0;
  double kept_share = 1.0; // of each group
  if (all > max_points) {
    min_quota = std::min (wanted_quota, max_points / (2 * sizes.size()));
    kept_share = double (max_points - min_quota * sizes.size()) / double (all);
  }
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const auto in_proportion =
        static_cast<std::size_t> (std::floor (kept_share * double (sizes[i])));
    groups_[i].quota = std::min (sizes[i], std::max (min_quota, in_proportion));
  }
}

bool
PointSample::isBefore (const HashedPoint& a, const HashedPoint& b)
{
  if (a.hash != b.hash)
    return a.hash < b.hash;
  return std::lexicographical_compare (
      a.position.begin(), a.position.end(), b.position.begin(), b.position.end());
}

void
PointSample::keepFirst (Group& group)
{
  std::vector<HashedPoint>& points = group.points;
  const auto end = points.begin() + static_cast<std::ptrdiff_t> (group.quota);
  if (group.quota < points.size())
    std::nth_element (points.begin(), end, points.end(), isBefore);
  points.erase (end, points.end());
}

void
PointSample::add (std::size_t group_index, const Eigen::Vector3d& position)
{
  // A group drops points when it has this number more than twice its quota. Without
  // this number a group with a small quota would drop points often.
  constexpr std::size_t further_points = 100;
  if (!position.allFinite())
    return;
  Group& group = groups_[group_index];
  ++group.all_points;
  group.points.push_back ({hashOf (position), position});
  if (group.points.size() >= 2 * group.quota + further_points)
    keepFirst (group);
}

std::vector<SampledPoints>
PointSample::take()
{
  std::vector<SampledPoints> samples;
  for (Group& group : groups_) {
    if (group.points.size() > group.quota)
      keepFirst (group);
    std::sort (group.points.begin(), group.points.end(), isBefore);
    SampledPoints& sample = samples.emplace_back();
    sample.all_points = group.all_points;
    sample.positions.reserve (group.points.size());
    for (const HashedPoint& point : group.points)
      sample.positions.push_back (point.position);
    group = {};
  }
  return samples;
}

} // namespace pcl_ops::apps
