// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/search/kdtree.h>

#include "data_sets.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pcl_ops::evaluation {

namespace {

constexpr std::size_t fewest_points_of_region = 50; // the paper's, section IV-A
constexpr double max_distance = 0.05; // of a point to the plane of its region [m]
/** The plane of a region is fitted first when the region has this number of points, and
 * again whenever the number has grown by this factor: both are chosen by hand, and save
 * a fit for each point. */
constexpr double points_of_first_fit = 10.0, growth_until_next_fit = 1.3;

struct PointWithNormal {
  Vector3d position;
  pcl::Indices neighbors; // nearest points of the cloud, the point itself included
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();
  /** Smallest eigenvalue of the covariance of the neighbors over the sum of all three;
   * infinite if there is no normal. */
  float curvature = std::numeric_limits<float>::infinity();
};

/** \param[in] neighbors number of neighbors, the point itself included */
std::vector<PointWithNormal>
pointsWithNormals (const XyzCloud& cloud, int neighbors)
{
  std::vector<PointWithNormal> points;
  if (cloud.empty())
    return points;
  for (const pcl::PointXYZ& position : cloud)
    points.push_back ({position.getVector3fMap().cast<double>(), {}});
  pcl::search::KdTree<pcl::PointXYZ> tree;
  tree.setInputCloud (cloud.makeShared());
  const int neighbor_count = std::min (int (cloud.size()), std::max (1, neighbors));
  std::vector<float> squared_distances; // not used
  for (std::size_t i = 0; i < points.size(); ++i) {
    PointWithNormal& point = points[i];
    tree.nearestKSearch (cloud[i], neighbor_count, point.neighbors, squared_distances);
    Moments moments;
    moments.origin = point.position;
    for (const pcl::index_t j : point.neighbors)
      addTo (moments, points[j].position);
    if (const std::optional<PlaneFit> fit = fitPlane (moments)) {
      point.normal = fit->plane.normal.cast<float>();
      point.curvature = float (fit->variances[0] / fit->variances.sum());
    }
  }
  return points;
}

/** Grows a region from a seed point and marks its points as taken.
 * \param[in,out] is_taken for each point, whether it is in this or an earlier region */
pcl::PointIndices
regionFrom (pcl::index_t seed,
            const std::vector<PointWithNormal>& points,
            std::vector<bool>& is_taken)
{
  const auto min_cosine = float (std::cos (paper_angle_tolerance));
  Moments moments;
  moments.origin = points[seed].position;
  moments.add (0.0, 0.0, 0.0); // the seed, relative to the origin
  Plane plane = planeThrough (moments.origin, points[seed].normal.cast<double>());
  double points_of_next_fit = points_of_first_fit;
  pcl::PointIndices region;
  region.indices = {seed};
  is_taken[seed] = true;
  for (std::size_t next = 0; next < region.indices.size(); ++next) {
    const PointWithNormal& member = points[region.indices[next]];
    for (const pcl::index_t j : member.neighbors) {
      const PointWithNormal& other = points[j];
      const bool stays_outside =
          is_taken[j] || std::abs (other.normal.dot (member.normal)) < min_cosine ||
          std::abs (plane.distance (other.position)) > max_distance;
      if (stays_outside)
        continue;
      is_taken[j] = true;
      region.indices.push_back (j);
      addTo (moments, other.position);
      if (moments.count < points_of_next_fit)
        continue;
      points_of_next_fit = growth_until_next_fit * moments.count;
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
  const std::vector<PointWithNormal> points = pointsWithNormals (cloud, neighbors);
  pcl::Indices flattest_first (points.size());
  std::iota (flattest_first.begin(), flattest_first.end(), 0);
  std::stable_sort (flattest_first.begin(), flattest_first.end(), [&] (auto a, auto b) {
    return points[a].curvature < points[b].curvature;
  });
  std::vector<bool> is_taken (points.size(), false);
  std::vector<pcl::PointIndices> regions;
  for (const pcl::index_t seed : flattest_first)
    if (!is_taken[seed] && std::isfinite (points[seed].curvature)) {
      regions.push_back (regionFrom (seed, points, is_taken));
      if (regions.back().indices.size() < fewest_points_of_region)
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
  const std::size_t min_points = parameters.min_points;
  dropSmallPlanes (labels,
                   std::min (min_points, cloud.min_plane_points.value_or (min_points)));
  return labels;
}

} // namespace pcl_ops::evaluation
