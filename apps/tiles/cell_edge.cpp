// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cell_edge.h"

#include <pcl/point_types.h>

#include <cli/errors.h>
#include <pcl_ops/oriented_point_sampling.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace pcl_ops::apps {

namespace {

/** \return 0 where most places are one */
double
unroundedEdgeFor (const std::vector<Eigen::Vector3d>& places,
                  const Eigen::Vector3d& zero,
                  std::uint64_t points)
{
  constexpr double points_of_cell = 20.0;
  pcl::PointCloud<pcl::PointXYZ> near_zero;
  for (const Eigen::Vector3d& place : places) {
    const Eigen::Vector3f local = (place - zero).cast<float>();
    near_zero.push_back ({local.x(), local.y(), local.z()});
  }
  return voxelSizeFor (CloudView (near_zero),
                       std::max (1.0, static_cast<double> (points) / points_of_cell));
}

} // namespace

std::vector<Eigen::Vector3d>
evenSample (const std::vector<std::vector<Eigen::Vector3d>>& places, const Plan& plan)
{
  // What the densest input has to say limits all.
  double per_point = 1.0;
  for (std::size_t i = 0; i < places.size(); ++i)
    per_point = std::min (per_point,
                          static_cast<double> (places[i].size()) /
                              static_cast<double> (plan.inputs[i].points));
  std::vector<Eigen::Vector3d> even;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto wanted = static_cast<std::size_t> (
        std::ceil (per_point * static_cast<double> (plan.inputs[i].points)));
    const std::size_t count = std::min (wanted, places[i].size());
    for (std::size_t k = 0; k < count; ++k)
      even.push_back (places[i][k * places[i].size() / count]);
  }
  return even;
}

double
cellEdgeFor (std::vector<Eigen::Vector3d> places,
             const Eigen::Vector3d& zero,
             std::uint64_t points)
{
  double edge = unroundedEdgeFor (places, zero, points);
  if (!(edge > 0.0)) {
    // Most are at one place: the others tell.
    const auto components = [] (const Eigen::Vector3d& place) {
      return std::make_tuple (place.x(), place.y(), place.z());
    };
    std::sort (places.begin(), places.end(), [&] (const auto& one, const auto& other) {
      return components (one) < components (other);
    });
    places.erase (std::unique (places.begin(), places.end()), places.end());
    edge = unroundedEdgeFor (places, zero, points);
  }
  if (!(edge > 0.0))
    throw WorkError ("INPUT", "has its points at one place; give --cell");
  const double digit = std::pow (10.0, std::floor (std::log10 (edge)) - 1.0);
  return std::round (edge / digit) * digit;
}

} // namespace pcl_ops::apps
