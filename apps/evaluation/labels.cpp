// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "labels.h"

#include <algorithm>

namespace pcl_ops::evaluation {

PlaneIds
planeIds (const Labels& labels)
{
  PlaneIds ids;
  ids.label = labels;
  std::sort (ids.label.begin(), ids.label.end());
  ids.label.erase (std::unique (ids.label.begin(), ids.label.end()), ids.label.end());
  if (!ids.label.empty() && ids.label.front() == 0)
    ids.label.erase (ids.label.begin());
  ids.points.assign (ids.label.size(), 0);
  ids.of_point.reserve (labels.size());
  for (const std::uint32_t label : labels) {
    if (label == 0) {
      ids.of_point.push_back (PlaneIds::none);
      continue;
    }
    const auto found = std::lower_bound (ids.label.begin(), ids.label.end(), label);
    const auto id = static_cast<std::uint32_t> (found - ids.label.begin());
    ids.of_point.push_back (id);
    ++ids.points[id];
  }
  return ids;
}

void
dropSmallPlanes (Labels& labels, std::size_t min_points)
{
  const PlaneIds ids = planeIds (labels);
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (labels[i] != 0 && ids.points[ids.of_point[i]] < min_points)
      labels[i] = 0;
}

} // namespace pcl_ops::evaluation
