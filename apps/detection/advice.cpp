// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "advice.h"

#include <pcl/common/point_tests.h>

#include <boost/format.hpp>

#include <Eigen/Geometry>

#include <numbers/statistics.h>
#include <pcl_ops/fast_sampling_plane_filtering.h>
#include <pcl_ops/kernel_hough_transform.h>
#include <pcl_ops/oriented_point_sampling.h>

#include <optional>

namespace pcl_ops::apps {

namespace {

using boost::format;
using Points = std::vector<Eigen::Vector3f>;
using Planes = std::vector<PlaneSegment>;

/** \brief Says that the unit may be the millimeter; empty if nothing tells so. */
template <typename Parameters>
std::string
adviceOnUnit (const Parameters& parameters, const Points& points)
{
  constexpr bool is_fspf =
      std::is_same_v<Parameters, FastSamplingPlaneFilteringParameters>;
  // On surfels the noise sets the distance unless the user does.
  const std::optional<double>& threshold = parameters.distance_threshold;
  // A room of 10 m in millimeters; no scene in meters is that large for 5 cm.
  constexpr double max_extent_in_thresholds = 40000.0;
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3f& point : points)
    box.extend (point.cast<double>());
  const double extent = box.diagonal().norm();
  if (!threshold || extent <= max_extent_in_thresholds * *threshold)
    return "";
  return str (format ("the cloud is %1% wide: if its unit is the millimeter, give %2% "
                      "in millimeters, too (threshold now %3%)") %
              extent % (is_fspf ? "--threshold and --inner-radius" : "--threshold") %
              *threshold);
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
    const auto size = std::count_if (points.begin(), points.end(), [&] (auto& point) {
      return (point - center).squaredNorm() <= squared;
    });
    sizes.push_back (static_cast<double> (size));
  }
  return quantile (sizes, 0.5);
}

std::string
advice (const OrientedPointSamplingParameters& parameters, const Points& points, bool)
{
  const double samples =
      std::floor (parameters.sampling_rate * static_cast<double> (points.size()));
  if (parameters.sampling == Sampling::Points && samples <= parameters.min_inliers)
    return str (format ("only %1% of %2% points were sampled and a plane needs more "
                        "than --min-inliers %3%: raise --sampling-rate (%4%) or lower "
                        "--min-inliers") %
                samples % points.size() % parameters.min_inliers %
                parameters.sampling_rate);
  const std::optional<double>& threshold = parameters.distance_threshold;
  return str (format ("lower --min-inliers (%1%) or raise --sampling-rate (%2%) if the "
                      "planes are small, raise --threshold (%3%) if the points are "
                      "noisy") %
              parameters.min_inliers % parameters.sampling_rate %
              (threshold ? std::to_string (*threshold) : "auto"));
}

std::string
advice (const FastSamplingPlaneFilteringParameters& parameters,
        const Points& points,
        bool)
{
  const auto& local = parameters.local;
  const double held = medianSphereSize (points, local.outer_radius);
  if (held < local.local_samples)
    return str (format ("half of the spheres of --outer-radius %1% hold %2% points or "
                        "fewer and --local-samples %3% are needed: raise the radius or "
                        "lower the samples") %
                local.outer_radius % held % local.local_samples);
  return str (format ("raise --threshold (%1%) or lower --min-inlier-share (%2%) if "
                      "the points are noisy, lower --outer-radius (%3%) if the planes "
                      "are small") %
              *parameters.distance_threshold % local.min_inlier_fraction %
              local.outer_radius);
}

std::string
advice (const KernelHoughTransformParameters& parameters,
        const Points&,
        bool found_none)
{
  const auto& clusters = parameters.clusters;
  if (found_none)
    return str (format ("no octree node from --s-level %1% on is flat and has "
                        "--min-samples %2% points: lower either, or --s-alpha (%3%) if "
                        "the points are noisy") %
                clusters.first_level % clusters.min_samples % clusters.s_alpha);
  return str (format ("few octree nodes are flat: raise --threshold (%1%), or lower "
                      "--min-samples (%2%) for more of them") %
              *parameters.distance_threshold % clusters.min_samples);
}

} // namespace

template <typename Parameters>
std::string
adviceFor (const Parameters& parameters, const XyzCloud& cloud, const Planes& planes)
{
  constexpr double min_share = 0.05;
  const auto readings = std::count_if (
      cloud.begin(), cloud.end(), [] (auto& point) { return pcl::isFinite (point); });
  std::size_t covered = 0;
  for (const PlaneSegment& plane : planes)
    covered += plane.inliers.size();
  if (covered > 0 &&
      static_cast<double> (covered) >= min_share * static_cast<double> (readings))
    return "";
  if (readings == 0)
    return "every point is NaN or infinite";
  Points points;
  for (const pcl::PointXYZ& point : cloud)
    if (pcl::isFinite (point))
      points.emplace_back (point.getVector3fMap());
  const std::string on_unit = adviceOnUnit (parameters, points);
  return on_unit.empty() ? advice (parameters, points, planes.empty()) : on_unit;
}

template std::string
adviceFor (const OrientedPointSamplingParameters&, const XyzCloud&, const Planes&);
template std::string
adviceFor (const FastSamplingPlaneFilteringParameters&, const XyzCloud&, const Planes&);
template std::string
adviceFor (const KernelHoughTransformParameters&, const XyzCloud&, const Planes&);

} // namespace pcl_ops::apps
