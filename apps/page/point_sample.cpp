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
  constexpr std::size_t enough = 100;
  const std::size_t all = std::accumulate (sizes.begin(), sizes.end(), std::size_t (0));
  std::size_t least = 0;
  double share = 1.0;
  if (all > max_points) {
    least = std::min (enough, max_points / (2 * sizes.size()));
    share = double (max_points - least * sizes.size()) / double (all);
  }
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const auto shared =
        static_cast<std::size_t> (std::floor (share * double (sizes[i])));
    groups_[i].quota = std::min (sizes[i], std::max (least, shared));
  }
}

bool
PointSample::isBefore (const Turn& a, const Turn& b)
{
  if (a.hash != b.hash)
    return a.hash < b.hash;
  return std::lexicographical_compare (
      a.place.begin(), a.place.end(), b.place.begin(), b.place.end());
}

void
PointSample::keepFirst (Group& group)
{
  std::vector<Turn>& turns = group.turns;
  const auto end = turns.begin() + static_cast<std::ptrdiff_t> (group.quota);
  if (group.quota < turns.size())
    std::nth_element (turns.begin(), end, turns.end(), isBefore);
  turns.erase (end, turns.end());
}

void
PointSample::add (std::size_t group, const Eigen::Vector3d& place)
{
  constexpr std::size_t waiting = 100; // so that small groups are seldom selected from
  if (!place.allFinite())
    return;
  Group& to = groups_[group];
  ++to.all;
  to.turns.push_back ({hashOf (place), place});
  if (to.turns.size() >= 2 * to.quota + waiting)
    keepFirst (to);
}

std::vector<SampledPoints>
PointSample::take()
{
  std::vector<SampledPoints> samples;
  for (Group& group : groups_) {
    if (group.turns.size() > group.quota)
      keepFirst (group);
    std::sort (group.turns.begin(), group.turns.end(), isBefore);
    SampledPoints& sample = samples.emplace_back();
    sample.all = group.all;
    sample.places.reserve (group.turns.size());
    for (const Turn& turn : group.turns)
      sample.places.push_back (turn.place);
    group = {};
  }
  return samples;
}

} // namespace pcl_ops::apps
