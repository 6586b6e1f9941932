// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "region_growing.h"

#include <pcl/search/kdtree.h>

#include <pcl_ops/plane.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pcl_ops::evaluation {

namespace {

/** The region's plane is fitted again each time its points have grown by this factor.
 */
constexpr double refit_growth = 1.3;
constexpr double points_of_first_fit = 10.0;

/** The points of a cloud with what their neighborhoods tell. */
struct Surfels {
  XyzCloud::Ptr cloud;
  std::size_t neighbors_per_point = 0;
  /** \ref neighbors_per_point of each point in turn. */
  pcl::Indices neighbors;
  std::vector<Eigen::Vector3f> normal;
  /** Share of the smallest variance; infinite where there is no normal. */
  std::vector<float> curvature;

  std::size_t
  size () const
  {
    return cloud->size();
  }
};

void
addTo (Moments& moments, const pcl::PointXYZ& point)
{
  const Eigen::Vector3d local = point.getVector3fMap().cast<double>() - moments.origin;
  moments.add (local.x(), local.y(), local.z());
}

void
orient (Surfels& surfels, std::size_t i)
{
  Moments moments;
  moments.origin = (*surfels.cloud)[i].getVector3fMap().cast<double>();
  const auto* const first = &surfels.neighbors[i * surfels.neighbors_per_point];
  for (const auto* j = first; j != first + surfels.neighbors_per_point; ++j)
    addTo (moments, (*surfels.cloud)[*j]);
  surfels.curvature[i] = std::numeric_limits<float>::infinity();
  if (const std::optional<PlaneFit> fit = fitPlane (moments)) {
    surfels.normal[i] = fit->plane.normal.cast<float>();
    surfels.curvature[i] =
        static_cast<float> (fit->variances[0] / fit->variances.sum());
  }
}

Surfels
surfelsOf (const XyzCloud& cloud, int neighbors)
{
  Surfels surfels;
  surfels.cloud = cloud.makeShared();
  surfels.neighbors_per_point =
      std::min (surfels.size(), static_cast<std::size_t> (std::max (1, neighbors)));
  surfels.normal.resize (surfels.size(), Eigen::Vector3f::Zero());
  surfels.curvature.resize (surfels.size());
  if (surfels.size() == 0)
    return surfels;

  pcl::search::KdTree<pcl::PointXYZ> tree;
  tree.setInputCloud (surfels.cloud);
  pcl::Indices found;
  std::vector<float> ignored;
  for (std::size_t i = 0; i < surfels.size(); ++i) {
    tree.nearestKSearch (
        (*surfels.cloud)[i], int (surfels.neighbors_per_point), found, ignored);
    surfels.neighbors.insert (surfels.neighbors.end(), found.begin(), found.end());
    orient (surfels, i);
  }
  return surfels;
}

/** A plane that grows. */
struct Region {
  Moments moments;
  Plane plane;
  double points_of_next_fit = points_of_first_fit;

  Region (const pcl::PointXYZ& seed, const Eigen::Vector3f& normal)
  {
    moments.origin = seed.getVector3fMap().cast<double>();
    moments.add (0.0, 0.0, 0.0);
    plane = planeThrough (moments.origin, normal.cast<double>());
  }

  void
  add (const pcl::PointXYZ& point)
  {
    addTo (moments, point);
    if (moments.count < points_of_next_fit)
      return;
    points_of_next_fit = refit_growth * moments.count;
    if (const std::optional<PlaneFit> fit = fitPlane (moments))
      plane = fit->plane;
  }
};

void
growFrom (std::size_t seed,
          std::uint32_t label,
          const Surfels& surfels,
          const RegionGrowingParameters& parameters,
          PlaneLabels& labels)
{
  const auto min_cosine = static_cast<float> (std::cos (parameters.angle_threshold));
  Region region ((*surfels.cloud)[seed], surfels.normal[seed]);
  std::vector<std::size_t> members{seed};
  labels[seed] = label;
  for (std::size_t next = 0; next < members.size(); ++next) {
    const std::size_t member = members[next];
    const auto* const first = &surfels.neighbors[member * surfels.neighbors_per_point];
    for (const auto* j = first; j != first + surfels.neighbors_per_point; ++j) {
      const pcl::PointXYZ& point = (*surfels.cloud)[*j];
      if (labels[*j] != 0 ||
          std::abs (surfels.normal[*j].dot (surfels.normal[member])) < min_cosine ||
          std::abs (region.plane.distance (point.getVector3fMap().cast<double>())) >
              parameters.distance_threshold)
        continue;
      labels[*j] = label;
      region.add (point);
      members.push_back (static_cast<std::size_t> (*j));
    }
  }
}

} // namespace

PlaneLabels
growRegions (const XyzCloud& cloud, const RegionGrowingParameters& parameters)
{
  const Surfels surfels = surfelsOf (cloud, parameters.neighbors);
  std::vector<std::size_t> flattest_first (surfels.size());
  std::iota (flattest_first.begin(), flattest_first.end(), 0);
  std::stable_sort (
      flattest_first.begin(), flattest_first.end(), [&] (std::size_t a, std::size_t b) {
        return surfels.curvature[a] < surfels.curvature[b];
      });
  PlaneLabels labels (surfels.size(), 0);
  std::uint32_t regions = 0;
  for (const std::size_t seed : flattest_first)
    if (labels[seed] == 0 && std::isfinite (surfels.curvature[seed]))
      growFrom (seed, ++regions, surfels, parameters, labels);
  dropSmallPlanes (labels, parameters.min_points);
  sortBySize (labels);
  return labels;
}

} // namespace pcl_ops::evaluation
