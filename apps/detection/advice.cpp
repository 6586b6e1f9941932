// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "advice.h"

#include <pcl/common/point_tests.h>

#include <Eigen/Geometry>

#include <numbers/statistics.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>

namespace pcl_ops::apps {

namespace {

using Points = std::vector<Eigen::Vector3f>;

Points
finitePointsOf (const XyzCloud& cloud)
{
  Points points;
  for (const pcl::PointXYZ& point : cloud)
    if (pcl::isFinite (point))
      points.emplace_back (point.getVector3fMap());
  return points;
}

/** \brief What no method could cope with; empty if there is nothing.
 * \param[in] lengths the options with a length
 * \param[in] threshold none if it follows the noise */
std::string
adviceOnCloud (const Points& points,
               const std::string& lengths,
               std::optional<double> threshold)
{
  // A room of 10 m in millimeters; no scene in meters is that large for 5 cm.
  constexpr double max_extent_in_thresholds = 40000.0;
  if (points.empty())
    return "every point is NaN or infinite";
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3f& point : points)
    box.extend (point.cast<double>());
  const double extent = box.diagonal().norm();
  if (!(threshold && extent > max_extent_in_thresholds * *threshold))
    return "";
  std::ostringstream advice;
  advice << "the cloud is " << extent << " wide: if its unit is the millimeter, give "
         << lengths << " in millimeters, too (threshold now " << *threshold << ")";
  return advice.str();
}

/** \brief How many points there typically are in the spheres around points. */
double
medianSphereSize (const Points& points, double radius)
{
  constexpr std::size_t spheres = 101;
  const auto squared = static_cast<float> (radius * radius);
  std::vector<double> sizes;
  for (std::size_t i = 0; i < spheres; ++i) {
    const Eigen::Vector3f& center = points[i * points.size() / spheres];
    const auto size = std::count_if (
        points.begin(), points.end(), [&] (const Eigen::Vector3f& point) {
          return (point - center).squaredNorm() <= squared;
        });
    sizes.push_back (static_cast<double> (size));
  }
  return quantile (sizes, 0.5);
}

} // namespace

bool
isHardlyCovered (const XyzCloud& cloud, const std::vector<PlaneSegment>& planes)
{
  constexpr double min_share = 0.05;
  const auto points =
      std::count_if (cloud.begin(), cloud.end(), [] (const pcl::PointXYZ& point) {
        return pcl::isFinite (point);
      });
  std::size_t covered = 0;
  for (const PlaneSegment& plane : planes)
    covered += plane.inliers.size();
  return covered == 0 ||
         static_cast<double> (covered) < min_share * static_cast<double> (points);
}

std::string
adviceFor (const OrientedPointSamplingParameters& parameters,
           const XyzCloud& cloud,
           bool /* found_none */)
{
  const Points points = finitePointsOf (cloud);
  const double samples =
      std::floor (parameters.sampling_rate * static_cast<double> (points.size()));
  // On surfels the noise sets the distance unless the user does.
  const std::optional<double> threshold = parameters.distance_threshold;
  const std::string on_cloud = adviceOnCloud (points, "--threshold", threshold);
  const bool few_samples = !points.empty() && parameters.sampling == Sampling::Points &&
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
           const XyzCloud& cloud,
           bool /* found_none */)
{
  const FastSamplingPlaneFilteringParameters::Local& local = parameters.local;
  const Points points = finitePointsOf (cloud);
  std::string on_cloud = adviceOnCloud (
      points, "--threshold and --inner-radius", parameters.distance_threshold);
  if (!on_cloud.empty())
    return on_cloud;
  const double held = medianSphereSize (points, local.outer_radius);
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
           const XyzCloud& cloud,
           bool found_none)
{
  const auto& clusters = parameters.clusters;
  std::string on_cloud = adviceOnCloud (
      finitePointsOf (cloud), "--threshold", parameters.distance_threshold);
  if (!on_cloud.empty())
    return on_cloud;
  std::ostringstream advice;
  if (found_none)
    advice << "no octree node from --s-level " << clusters.first_level
           << " on is flat and has --min-samples " << clusters.min_samples
           << " points: lower either, or --s-alpha (" << clusters.s_alpha
           << ") if the points are noisy";
  else
    advice << "few octree nodes are flat: raise --threshold ("
           << *parameters.distance_threshold << "), or lower --min-samples ("
           << clusters.min_samples << ") for more of them";
  return advice.str();
}

} // namespace pcl_ops::apps
