// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "median_place.h"

#include <numbers/quantile.h>

#include <algorithm>
#include <utility>

namespace pcl_ops::apps {

Eigen::Vector3d
medianPlace (const std::vector<Eigen::Vector3d>& places)
{
  Eigen::Vector3d median;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    std::vector<double> coordinates;
    coordinates.reserve (places.size());
    for (const Eigen::Vector3d& place : places)
      coordinates.push_back (place[axis]);
    median[axis] = quantile (std::move (coordinates), 0.5);
  }
  return median;
}

std::vector<Eigen::Vector3d>
somePlaces (std::size_t size, const PlaceOf& place, std::size_t looked_at)
{
  const std::size_t stride = size / looked_at + 1;
  std::vector<Eigen::Vector3d> places;
  for (std::size_t begin = 0; begin < size; begin += stride)
    for (std::size_t i = begin; i < std::min (size, begin + stride); ++i)
      if (const Eigen::Vector3d found = place (i); found.allFinite()) {
        places.push_back (found);
        break;
      }
  return places;
}

Eigen::Vector3d
usualPlace (std::size_t size, const PlaceOf& place)
{
  constexpr std::size_t looked_at = 1000;
  const std::vector<Eigen::Vector3d> places = somePlaces (size, place, looked_at);
  return places.empty() ? Eigen::Vector3d (Eigen::Vector3d::Zero())
                        : medianPlace (places);
}

Eigen::Vector3d
nearestMultiple (const Eigen::Vector3d& place, double step)
{
  return (place / step).array().round() * step;
}

} // namespace pcl_ops::apps
