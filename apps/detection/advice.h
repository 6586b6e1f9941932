// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/common/point_tests.h>

#include <Eigen/Geometry>

#include "thickness.h"
#include <cli/text.h>
#include <io/shifted_cloud.h>
#include <numbers/statistics.h>
#include <pcl_ops/fast_sampling_plane_filtering.h>
#include <pcl_ops/kernel_hough_transform.h>
#include <pcl_ops/oriented_point_sampling.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <type_traits>

namespace pcl_ops::apps {

using FinitePoints = std::vector<Eigen::Vector3f>;

/** \brief Returns a hint that the unit of the cloud may be the millimeter; empty unless
 * the bounding box is far too wide for the threshold. */
template <typename Parameters>
std::string
adviceOnUnit (const Parameters& parameters, const FinitePoints& points)
{
  constexpr bool is_fspf =
      std::is_same_v<Parameters, FastSamplingPlaneFilteringParameters>;
  // By default OPS has no threshold: it follows the noise of the cloud.
  const std::optional<double>& threshold = parameters.distance_threshold;
  // In millimeters a room of 10 m is 200,000 times as wide as the usual threshold of
  // 0.05. In meters a scene of 40,000 thresholds would be 2 km wide.
  constexpr double max_extent_in_thresholds = 40000.0;
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3f& point : points)
    box.extend (point.cast<double>());
  const double extent = box.diagonal().norm();
  if (!threshold || extent <= max_extent_in_thresholds * *threshold)
    return "";
  const char* lengths = is_fspf ? "--threshold and --inner-radius" : "--threshold";
  return concatenate ("the cloud is ",
                      extent,
                      " wide: if its unit is the millimeter, give ",
                      lengths,
                      " in millimeters, too (threshold now ",
                      *threshold,
                      ")");
}

/** \brief Returns the median number of points within a radius of a point, by 101
 * points of the cloud. */
inline double
medianSphereSize (const FinitePoints& points, double radius)
{
  constexpr std::size_t spheres = 101;
  const auto squared = float (radius * radius);
  std::vector<double> sizes;
  for (std::size_t i = 0; i < spheres; ++i) {
    const Eigen::Vector3f& center = points[i * points.size() / spheres];
    sizes.push_back (std::count_if (points.begin(), points.end(), [&] (auto& point) {
      return (point - center).squaredNorm() <= squared;
    }));
  }
  return quantile (sizes, 0.5);
}

inline std::string
adviceOn (const OrientedPointSamplingParameters& parameters,
          const FinitePoints& points,
          bool)
{
  const double samples = std::floor (parameters.sampling_rate * points.size());
  if (parameters.sampling == Sampling::Points && samples <= parameters.min_samples)
    return concatenate (
        "only ",
        samples,
        " of ",
        points.size(),
        " points were sampled and a plane needs more than --min-inliers ",
        parameters.min_samples,
        ": raise --sampling-rate (",
        parameters.sampling_rate,
        ") or lower --min-inliers");
  constexpr double few = 8.0; // fewer points fit a plane even if they are noise
  const std::optional<double>& size = parameters.surfels.voxel_size;
  const double held = size ? medianSphereSize (points, *size) : few;
  if (held < few)
    return concatenate ("half of the voxels of --voxel-size ",
                        *size,
                        " hold ",
                        held,
                        " points or fewer: raise it, or leave it out");
  const std::optional<double>& threshold = parameters.distance_threshold;
  const std::string if_noisy =
      concatenate (" if the planes are small, raise --threshold (",
                   threshold ? concatenate (*threshold) : "auto",
                   ") if the points are noisy");
  // With neighborhoods a --min-inliers below the default finds no more planes: the
  // evidence is against them.
  const bool asks_for_more =
      parameters.min_samples > OrientedPointSamplingParameters().min_samples;
  const std::string min_inliers =
      concatenate ("lower --min-inliers (", parameters.min_samples, ")");
  const std::string sampling_rate =
      concatenate ("raise --sampling-rate (", parameters.sampling_rate, ")");
  if (parameters.sampling == Sampling::Points)
    return min_inliers + " or " + sampling_rate + if_noisy;
  return (size || asks_for_more ? min_inliers : sampling_rate) + if_noisy;
}

inline std::string
adviceOn (const FastSamplingPlaneFilteringParameters& parameters,
          const FinitePoints& points,
          bool)
{
  const auto& local = parameters.local;
  const double held = medianSphereSize (points, local.outer_radius);
  if (held < local.local_samples)
    return concatenate ("half of the spheres of --outer-radius ",
                        local.outer_radius,
                        " hold ",
                        held,
                        " points or fewer and --local-samples ",
                        local.local_samples,
                        " are needed: raise the radius or lower the samples");
  return concatenate ("raise --threshold (",
                      *parameters.distance_threshold,
                      ") or lower --min-inlier-share (",
                      local.min_inlier_fraction,
                      ") if the points are noisy, lower --outer-radius (",
                      local.outer_radius,
                      ") if the planes are small");
}

inline std::string
adviceOn (const KernelHoughTransformParameters& parameters,
          const FinitePoints&,
          bool found_none)
{
  const auto& clusters = parameters.clusters;
  if (found_none)
    return concatenate ("no octree node from --s-level ",
                        clusters.first_level,
                        " on is flat and has --min-samples ",
                        clusters.min_samples,
                        " points: lower either, or --s-alpha (",
                        clusters.s_alpha,
                        ") if the points are noisy");
  return concatenate ("few octree nodes are flat: raise --threshold (",
                      *parameters.distance_threshold,
                      "), or lower --min-samples (",
                      clusters.min_samples,
                      ") for more of them");
}

/** \brief Returns the share of the points that should be on planes. If fewer are, a
 * parameter is taken not to fit the cloud, and advice is given. */
inline double
minShareOf (const OrientedPointSamplingParameters& parameters)
{
  // Even voxels that hold few points give some planes by chance.
  return parameters.surfels.voxel_size ? 0.1 : 0.05;
}

template <typename Parameters>
double
minShareOf (const Parameters&)
{
  return 0.05;
}

/** \brief Returns which parameter to change, as the end of a sentence, if fewer of the
 * finite points than \ref minShareOf are on planes; else an empty string. */
template <typename Parameters>
std::string
adviceFor (const Parameters& parameters,
           const XyzCloud& cloud,
           const std::vector<PlaneSegment>& planes)
{
  const double min_share = minShareOf (parameters);
  const auto readings = std::count_if (
      cloud.begin(), cloud.end(), [] (auto& point) { return pcl::isFinite (point); });
  std::size_t covered = 0;
  for (const PlaneSegment& plane : planes)
    covered += plane.inliers.size();
  if (covered > 0 && covered >= min_share * readings)
    return "";
  if (readings == 0)
    return "every point is NaN or infinite";
  constexpr int points_of_a_plane = 3;
  if (readings <= points_of_a_plane)
    return concatenate (
        "the cloud has ", points_of_a_plane, " points or fewer, which tell no plane");
  FinitePoints points;
  for (const pcl::PointXYZ& point : cloud)
    if (pcl::isFinite (point))
      points.emplace_back (point.getVector3fMap());
  const std::string on_unit = adviceOnUnit (parameters, points);
  return on_unit.empty() ? adviceOn (parameters, points, planes.empty()) : on_unit;
}

/** \brief Whether the rms distance of a plane is larger than the spacing of its points:
 * voxels cannot resolve thinner planes. */
inline bool
isThickerThanSpacing (const PlaneSegment& plane)
{
  constexpr double pi = 3.14159265358979323846;
  const std::optional<PlaneFit> fit = fitPlane (plane.moments);
  if (!fit)
    return false;
  // Points spread evenly over an ellipse: its area is 4 pi sqrt (v1 v2).
  const Eigen::Vector3d& variances = fit->variances;
  const double area = 4.0 * pi * std::sqrt (variances[1] * variances[2]);
  return variances[0] * plane.moments.count > area;
}

/** \brief Returns a hint to give --voxel-size if most points on planes are on thick
 * planes (\ref thick_factor); else an empty string. Measures only the four largest
 * planes for which \ref isThickerThanSpacing is true, by 8 points each.
 * \param[in] planes by falling size */
inline std::string
hintOnThickPlanes (const XyzCloud& cloud, const std::vector<PlaneSegment>& planes)
{
  constexpr double min_share = 0.6;
  constexpr std::size_t largest = 4;
  constexpr std::size_t probes = 8;
  std::vector<PlaneSegment> candidates;
  std::size_t found = 0;
  std::size_t suspicious = 0;
  for (const PlaneSegment& plane : planes) {
    found += plane.inliers.size();
    if (candidates.size() < largest && isThickerThanSpacing (plane)) {
      candidates.push_back (plane);
      suspicious += plane.inliers.size();
    }
  }
  if (fraction (suspicious, found, 0.0) < min_share)
    return "";
  const std::vector<Thickness> all = thicknessOf (cloud, candidates, probes);
  std::size_t thick = 0;
  std::optional<double> spacing; // of the points of the largest thick plane
  for (std::size_t i = 0; i < candidates.size(); ++i)
    if (all[i].factor() > thick_factor) {
      thick += candidates[i].inliers.size();
      spacing = spacing.value_or (all[i].spacing);
    }
  const double share = fraction (thick, found, 0.0);
  if (share < min_share)
    return "";
  // A surfel needs several points, and more points than empty voxels around it.
  constexpr double size_by_spacing = 2.0;
  const double size = size_by_spacing * *spacing;
  const double digit = std::pow (10.0, std::floor (std::log10 (size)));
  return concatenate ("planes are thick: ",
                      std::lrint (100.0 * share),
                      " % of the points on planes are on such as are more than ",
                      thick_factor,
                      " times thicker than their surroundings: give --voxel-size ",
                      digit * std::round (size / digit),
                      ", or more for larger planes");
}

} // namespace pcl_ops::apps
