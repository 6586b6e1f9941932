// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "advice.h"

#include <pcl/common/point_tests.h>

#include <kht/octree_clusters.h>
#include <numbers/quantile.h>
#include <search/fixed_radius_search.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace pcl_ops::apps {

using namespace internal;

namespace {

Points
finitePointsOf (const pcl::PointCloud<pcl::PointXYZ>& cloud)
{
  pcl::Indices all (cloud.size());
  std::iota (all.begin(), all.end(), 0);
  constexpr unsigned one_thread = 1;
  return finitePoints (CloudView (cloud), all, one_thread);
}

/** \brief Diagonal of the box around points. */
double
extentOf (const Coordinates& points)
{
  double squared = 0.0;
  for (const std::vector<float>* axis : {&points.x, &points.y, &points.z}) {
    const auto [least, most] = std::minmax_element (axis->begin(), axis->end());
    const double edge = static_cast<double> (*most) - *least;
    squared += edge * edge;
  }
  return std::sqrt (squared);
}

/** \brief What no method could cope with; empty if there is nothing.
 * \param[in] lengths the options with a length
 * \param[in] threshold none if it follows the noise */
std::string
adviceOnCloud (const Points& points,
               const std::string& lengths,
               std::optional<double> threshold)
{
  // A room of 10 m in millimetres; no scene in metres is that large for 5 cm.
  constexpr double largest_extent_in_thresholds = 40000.0;
  if (points.size() == 0)
    return "every point is NaN or infinite";
  const double extent = extentOf (points);
  if (!(threshold && extent > largest_extent_in_thresholds * *threshold))
    return "";
  std::ostringstream advice;
  advice << "the cloud is " << extent << " wide: if its unit is the millimetre, give "
         << lengths << " in millimetres, too (threshold now " << *threshold << ")";
  return advice.str();
}

/** \brief How many points there typically are in the spheres around points. */
double
medianSphereSize (const Points& points, double radius, unsigned threads)
{
  constexpr std::size_t spheres = 101;
  const FixedRadiusSearch search (points, radius, threads);
  std::vector<double> sizes;
  Indices sphere;
  for (std::size_t i = 0; i < spheres; ++i) {
    search.find (static_cast<std::uint32_t> (i * points.size() / spheres), sphere);
    sizes.push_back (static_cast<double> (sphere.size()));
  }
  return quantile (sizes, 0.5);
}

} // namespace

bool
isHardlyCovered (const pcl::PointCloud<pcl::PointXYZ>& cloud,
                 const std::vector<PlaneSegment>& planes)
{
  constexpr double least_share = 0.05;
  const auto points =
      std::count_if (cloud.begin(), cloud.end(), [] (const pcl::PointXYZ& point) {
        return pcl::isFinite (point);
      });
  std::size_t covered = 0;
  for (const PlaneSegment& plane : planes)
    covered += plane.inliers.size();
  return covered == 0 ||
         static_cast<double> (covered) < least_share * static_cast<double> (points);
}

std::string
adviceFor (const OrientedPointSamplingParameters& parameters,
           const pcl::PointCloud<pcl::PointXYZ>& cloud)
{
  const Points points = finitePointsOf (cloud);
  const double samples =
      std::floor (parameters.sampling_rate * static_cast<double> (points.size()));
  // On surfels the noise sets the distance unless the user does.
  const std::optional<double> threshold = parameters.distance_threshold;
  const std::string on_cloud = adviceOnCloud (points, "--threshold", threshold);
  const bool few_samples = points.size() > 0 &&
                           parameters.sampling == Sampling::Points &&
                           samples <= parameters.min_inliers;
  std::ostringstream advice;
  if (few_samples)
    advice << "only " << samples << " of " << points.size()
           << " points were sampled and a plane needs more than --min-inliers "
           << parameters.min_inliers << ": raise --sampling-rate ("
           << parameters.sampling_rate << ") or lower --min-inliers";
  else if (!on_cloud.empty())
    advice << on_cloud;
  else
    advice << "lower --min-inliers (" << parameters.min_inliers
           << ") or raise --sampling-rate (" << parameters.sampling_rate
           << ") if the planes are small, raise --threshold ("
           << (threshold ? std::to_string (*threshold) : "auto")
           << ") if the points are noisy";
  return advice.str();
}

std::string
adviceFor (const FastSamplingPlaneFilteringParameters& parameters,
           const pcl::PointCloud<pcl::PointXYZ>& cloud)
{
  const LocalSamplingParameters& local = parameters.local;
  const Points points = finitePointsOf (cloud);
  std::string on_cloud = adviceOnCloud (
      points, "--threshold and --inner-radius", parameters.distance_threshold);
  if (!on_cloud.empty())
    return on_cloud;
  const double held = medianSphereSize (points, local.outer_radius, parameters.threads);
  std::ostringstream advice;
  if (held < local.local_samples)
    advice << "half of the spheres of --outer-radius " << local.outer_radius << " hold "
           << held << " points or fewer and --local-samples " << local.local_samples
           << " are needed: raise the radius or lower the samples";
  else
    advice << "raise --threshold (" << *parameters.distance_threshold
           << ") or lower --min-inlier-share (" << local.min_inlier_fraction
           << ") if the points are noisy, lower --outer-radius (" << local.outer_radius
           << ") if the planes are small";
  return advice.str();
}

std::string
adviceFor (const KernelHoughTransformParameters& parameters,
           const pcl::PointCloud<pcl::PointXYZ>& cloud)
{
  const OctreeClusterParameters& clusters = parameters.clusters;
  const Points points = finitePointsOf (cloud);
  std::string on_cloud =
      adviceOnCloud (points, "--threshold", parameters.distance_threshold);
  if (!on_cloud.empty())
    return on_cloud;
  const std::size_t flat =
      findCoplanarClusters (points, clusters, parameters.threads).clusters.size();
  std::ostringstream advice;
  if (flat == 0)
    advice << "no octree node from --s-level " << clusters.first_level
           << " on is flat and has --min-samples " << clusters.min_samples
           << " points: lower either, or --s-alpha (" << clusters.s_alpha
           << ") if the points are noisy";
  else
    advice << "hardly a plane is left of " << flat
           << " flat octree nodes: raise --threshold ("
           << *parameters.distance_threshold << "), or lower --min-samples ("
           << clusters.min_samples << ") for more of them";
  return advice.str();
}

} // namespace pcl_ops::apps
