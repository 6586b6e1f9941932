// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/search/kdtree.h>

#include "data_sets.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pcl_ops::evaluation {

namespace {

constexpr std::size_t smallest_region = 50;
constexpr double max_distance = 0.05; // to a region's plane [m]
/** A region's plane is refitted whenever its number of points has grown by this factor.
 */
constexpr double refit_growth = 1.3;
constexpr double points_of_first_fit = 10.0;

struct Surfel {
  Vector3d position;
  pcl::Indices neighbors;
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();
  /** Smallest eigenvalue over their sum; infinite if there is no normal. */
  float curvature = std::numeric_limits<float>::infinity();
};

std::vector<Surfel>
surfelsOf (const XyzCloud& cloud, int neighbors)
{
  std::vector<Surfel> surfels;
  if (cloud.empty())
    return surfels;
  for (const pcl::PointXYZ& point : cloud)
    surfels.push_back ({point.getVector3fMap().cast<double>(), {}});
  pcl::search::KdTree<pcl::PointXYZ> tree;
  tree.setInputCloud (cloud.makeShared());
  const int wanted = std::min (int (cloud.size()), std::max (1, neighbors));
  std::vector<float> ignored;
  for (std::size_t i = 0; i < surfels.size(); ++i) {
    Surfel& surfel = surfels[i];
    tree.nearestKSearch (cloud[i], wanted, surfel.neighbors, ignored);
    Moments moments;
    moments.origin = surfel.position;
    for (const pcl::index_t j : surfel.neighbors)
      addTo (moments, surfels[j].position);
    if (const std::optional<PlaneFit> fit = fitPlane (moments)) {
      surfel.normal = fit->plane.normal.cast<float>();
      surfel.curvature = float (fit->variances[0] / fit->variances.sum());
    }
  }
  return surfels;
}

/** Grows a region from a seed point and marks its points as taken. */
pcl::PointIndices
regionFrom (pcl::index_t seed,
            const std::vector<Surfel>& surfels,
            std::vector<bool>& is_taken)
{
  const auto min_cosine = float (std::cos (paper_angle_tolerance));
  Moments moments;
  moments.origin = surfels[seed].position;
  moments.add (0.0, 0.0, 0.0);
  Plane plane = planeThrough (moments.origin, surfels[seed].normal.cast<double>());
  double points_of_next_fit = points_of_first_fit;
  pcl::PointIndices region;
  region.indices = {seed};
  is_taken[seed] = true;
  for (std::size_t next = 0; next < region.indices.size(); ++next) {
    const Surfel& member = surfels[region.indices[next]];
    for (const pcl::index_t j : member.neighbors) {
      const Surfel& other = surfels[j];
      if (is_taken[j] || std::abs (other.normal.dot (member.normal)) < min_cosine ||
          std::abs (plane.distance (other.position)) > max_distance)
        continue;
      is_taken[j] = true;
      region.indices.push_back (j);
      addTo (moments, other.position);
      if (moments.count < points_of_next_fit)
        continue;
      points_of_next_fit = refit_growth * moments.count;
      if (const std::optional<PlaneFit> fit = fitPlane (moments))
        plane = fit->plane;
    }
  }
  return region;
}

} // namespace

PlaneLabels
growRegions (const XyzCloud& cloud, int neighbors)
{
  const std::vector<Surfel> surfels = surfelsOf (cloud, neighbors);
  pcl::Indices flattest_first (surfels.size());
  std::iota (flattest_first.begin(), flattest_first.end(), 0);
  std::stable_sort (flattest_first.begin(), flattest_first.end(), [&] (auto a, auto b) {
    return surfels[a].curvature < surfels[b].curvature;
  });
  std::vector<bool> is_taken (surfels.size(), false);
  std::vector<pcl::PointIndices> regions;
  for (const pcl::index_t seed : flattest_first)
    if (!is_taken[seed] && std::isfinite (surfels[seed].curvature)) {
      regions.push_back (regionFrom (seed, surfels, is_taken));
      if (regions.back().indices.size() < smallest_region)
        regions.pop_back();
    }
  std::stable_sort (regions.begin(), regions.end(), [] (const auto& a, const auto& b) {
    return a.indices.size() > b.indices.size();
  });
  return labelsOf (regions, cloud.size());
}

PlaneLabels
truthOf (const EvaluationCloud& cloud, const TruthParameters& parameters)
{
  if (!cloud.truth && !cloud.grows_truth)
    return PlaneLabels (cloud.cloud->size(), 0);
  PlaneLabels labels =
      cloud.truth ? *cloud.truth : growRegions (*cloud.cloud, parameters.neighbors);
  const std::size_t usual = parameters.min_points;
  dropSmallPlanes (labels, std::min (usual, cloud.min_plane_points.value_or (usual)));
  return labels;
}

} // namespace pcl_ops::evaluation
