// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "size_classes.h"

#include "instance_metrics.h"

namespace pcl_ops::evaluation {

namespace {

std::vector<SizeClass>
emptySizeClasses ()
{
  std::vector<SizeClass> classes (1);
  for (const std::size_t points : {200, 500, 1000, 3000, 10'000}) {
    classes.back().below = points;
    classes.emplace_back();
    classes.back().fewest_points = points;
  }
  return classes;
}

} // namespace

std::vector<SizeClass>
sizeClasses (const Confusion& confusion)
{
  const std::vector<bool> found_50 = foundTruePlanes (confusion, 0.50);
  const std::vector<bool> found_75 = foundTruePlanes (confusion, 0.75);
  std::vector<SizeClass> classes = emptySizeClasses();
  for (std::size_t plane = 0; plane < confusion.truth.size(); ++plane) {
    auto of_plane = classes.begin();
    while (of_plane->below && confusion.truth.points[plane] >= *of_plane->below)
      ++of_plane;
    ++of_plane->planes;
    of_plane->found_50 += found_50[plane];
    of_plane->found_75 += found_75[plane];
  }
  return classes;
}

} // namespace pcl_ops::evaluation
