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

// Texts that say which option to change after a detection: advice if hardly any point
// is on a plane, and a hint if planes are thick. The texts name the options of
// programs.

/** \brief The finite points of a cloud. */
using FinitePoints = std::vector<Eigen::Vector3f>;

/** \brief Returns advice for a cloud whose unit may be the millimeter; empty unless the
 * threshold is set and the bounding box is far too wide for it. */
template <typename Parameters>
std::string
adviceOnUnit (const Parameters& parameters, const FinitePoints& points)
{
  constexpr bool is_fspf =
      std::is_same_v<Parameters, FastSamplingPlaneFilteringParameters>;
  // The threshold of OPS is not set by default: then it follows the noise of the cloud.
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
  const char* options = is_fspf ? "--threshold and --inner-radius" : "--threshold";
  return concatenate ("the cloud is ",
                      extent,
                      " wide: if its unit is the millimeter, give ",
                      options,
                      " in millimeters, too (threshold now ",
                      *threshold,
                      ")");
}

/** \brief Counts the points within a radius of each of 101 points of the cloud, and
 * returns the median of the counts.
 * \param[in] radius [unit of the cloud]
 * \param[in] points at least one */
inline double
medianPointsWithin (double radius, const FinitePoints& points)
{
  constexpr std::size_t spheres = 101; // odd: the median is one of the counts
  const auto squared_radius = float (radius * radius);
  std::vector<double> counts;
  for (std::size_t i = 0; i < spheres; ++i) {
    const Eigen::Vector3f& center = points[i * points.size() / spheres];
    counts.push_back (std::count_if (
        points.begin(), points.end(), [&] (const Eigen::Vector3f& point) {
          return (point - center).squaredNorm() <= squared_radius;
        }));
  }
  return quantile (counts, 0.5);
}

/** \brief Returns advice if OPS had too few samples, or voxels too few points, for any
 * plane; else an empty string. */
inline std::string
adviceOnTooFew (const OrientedPointSamplingParameters& parameters,
                const FinitePoints& points)
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
  constexpr double min_points = 8.0; // fewer points fit a plane even if they are noise
  const std::optional<double>& voxel_size = parameters.surfels.voxel_size;
  const double median_points =
      voxel_size ? medianPointsWithin (*voxel_size, points) : min_points;
  if (median_points < min_points)
    return concatenate ("half of the points have ",
                        median_points,
                        " or fewer points within --voxel-size ",
                        *voxel_size,
                        " of them: raise it, or leave it out");
  return "";
}

/** \brief Returns which option of OPS to change. The last parameter is for the overload
 * for 3D-KHT. */
inline std::string
adviceOn (const OrientedPointSamplingParameters& parameters,
          const FinitePoints& points,
          bool /*found_none*/)
{
  const std::string on_too_few = adviceOnTooFew (parameters, points);
  if (!on_too_few.empty())
    return on_too_few;
  const std::optional<double>& threshold = parameters.distance_threshold;
  const std::string small_or_noisy =
      concatenate (" if the planes are small, raise --threshold (",
                   threshold ? concatenate (*threshold) : "auto",
                   ") if the points are noisy");
  // On neighborhoods a --min-inliers below the default finds no more planes, as the
  // evidence is against smaller ones.
  const bool is_above_default =
      parameters.min_samples > OrientedPointSamplingParameters().min_samples;
  const std::string min_inliers =
      concatenate ("lower --min-inliers (", parameters.min_samples, ")");
  const std::string sampling_rate =
      concatenate ("raise --sampling-rate (", parameters.sampling_rate, ")");
  if (parameters.sampling == Sampling::Points)
    return min_inliers + " or " + sampling_rate + small_or_noisy;
  const bool is_on_voxels = parameters.surfels.voxel_size.has_value();
  return (is_on_voxels || is_above_default ? min_inliers : sampling_rate) +
         small_or_noisy;
}

/** \brief Returns which option of FSPF to change. The last parameter is for the
 * overload for 3D-KHT. */
inline std::string
adviceOn (const FastSamplingPlaneFilteringParameters& parameters,
          const FinitePoints& points,
          bool /*found_none*/)
{
  const FastSamplingPlaneFilteringParameters::Local& local = parameters.local;
  const double median_points = medianPointsWithin (local.outer_radius, points);
  if (median_points < local.local_samples)
    return concatenate ("half of the spheres of --outer-radius ",
                        local.outer_radius,
                        " hold ",
                        median_points,
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

/** \brief Returns which option of 3D-KHT to change.
 * \param[in] found_none whether no plane was found at all */
inline std::string
adviceOn (const KernelHoughTransformParameters& parameters,
          const FinitePoints& /*points*/,
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

/** \brief As many points, or fewer, give no plane. */
constexpr std::size_t most_points_without_plane = 3;

/** \brief Advice is given if a smaller share of the finite points is on planes. This
 * share and the next one are chosen by hand. */
constexpr double min_share_on_planes = 0.05;

/** \brief The same bound if --voxel-size is given. It is higher, as voxels that hold
 * few points give some planes by chance. */
constexpr double min_share_on_planes_of_voxels = 0.1;

/** \brief Returns the bound that applies to a detection with these parameters. */
inline double
minShareOnPlanes (const OrientedPointSamplingParameters& parameters)
{
  return parameters.surfels.voxel_size ? min_share_on_planes_of_voxels
                                       : min_share_on_planes;
}

/** \brief The same for FSPF and 3D-KHT, which have no voxels. */
template <typename Parameters>
double
minShareOnPlanes (const Parameters&)
{
  return min_share_on_planes;
}

/** \brief Returns why so few finite points tell no plane. Points of a file may be
 * finite, but not in single precision.
 * \param[in] finite_points at most \ref most_points_without_plane
 * \param[in] points number of all points */
inline std::string
reasonOfFewPoints (std::size_t finite_points, std::size_t points)
{
  if (finite_points == 0)
    return "every point is NaN or infinite in single precision (above 3.4e38)";
  if (points > most_points_without_plane)
    return concatenate (
        "all but ",
        finite_points,
        " of ",
        points,
        " points are NaN or infinite in single precision (above 3.4e38)");
  return concatenate ("the cloud has ",
                      most_points_without_plane,
                      " points or fewer, which tell no plane");
}

/** \brief Returns which option to change, or why the cloud has no planes, as the end of
 * a sentence; an empty string if enough of the finite points are on planes (\ref
 * minShareOnPlanes). */
template <typename Parameters>
std::string
adviceFor (const Parameters& parameters,
           const XyzCloud& cloud,
           const std::vector<PlaneSegment>& planes)
{
  const auto finite_points = static_cast<std::size_t> (
      std::count_if (cloud.begin(), cloud.end(), [] (const pcl::PointXYZ& point) {
        return pcl::isFinite (point);
      }));
  std::size_t on_planes = 0;
  for (const PlaneSegment& plane : planes)
    on_planes += plane.inliers.size();
  if (on_planes > 0 && on_planes >= minShareOnPlanes (parameters) * finite_points)
    return "";
  if (finite_points <= most_points_without_plane)
    return reasonOfFewPoints (finite_points, cloud.size());
  FinitePoints points;
  for (const pcl::PointXYZ& point : cloud)
    if (pcl::isFinite (point))
      points.emplace_back (point.getVector3fMap());
  const std::string on_unit = adviceOnUnit (parameters, points);
  return on_unit.empty() ? adviceOn (parameters, points, planes.empty()) : on_unit;
}

/** \brief Whether the rms distance of the points to a plane is larger than their
 * spacing on it. Planes that are not thicker get no hint, as voxels cannot resolve
 * them. */
inline bool
isThickerThanSpacing (const PlaneSegment& plane)
{
  const std::optional<PlaneFit> fit = fitPlane (plane.moments);
  if (!fit)
    return false;
  const Eigen::Vector3d& variances = fit->variances;
  // The area of an ellipse in which evenly spread points have these variances.
  const double area = 4.0 * M_PI * std::sqrt (variances[1] * variances[2]);
  // rms^2 > spacing^2, where rms^2 is the least variance and spacing^2 = area / count.
  return variances[0] * plane.moments.count > area;
}

/** \brief Returns the nearest number of one significant digit to a positive number. */
inline double
roundedToOneDigit (double number)
{
  const double unit = std::pow (10.0, std::floor (std::log10 (number)));
  return unit * std::round (number / unit);
}

/** \brief Returns a hint to give --voxel-size if 60 % or more of the points on planes
 * are on thick planes (\ref thick_factor); else an empty string. To save time it
 * measures the thickness of at most four planes, by 8 points each: the largest ones for
 * which \ref isThickerThanSpacing holds.
 * \param[in] planes by falling size */
inline std::string
hintOnThickPlanes (const XyzCloud& cloud, const std::vector<PlaneSegment>& planes)
{
  // Chosen by hand.
  constexpr double min_thick_share = 0.6; // of the points on planes
  constexpr std::size_t max_candidates = 4;
  constexpr std::size_t probes = 8; // points of each candidate
  std::vector<PlaneSegment> candidates;
  std::size_t on_planes = 0;
  std::size_t on_candidates = 0;
  for (const PlaneSegment& plane : planes) {
    on_planes += plane.inliers.size();
    if (candidates.size() < max_candidates && isThickerThanSpacing (plane)) {
      candidates.push_back (plane);
      on_candidates += plane.inliers.size();
    }
  }
  if (fraction (on_candidates, on_planes, 0.0) < min_thick_share)
    return "";
  const std::vector<Thickness> thicknesses = thicknessOf (cloud, candidates, probes);
  std::size_t on_thick_planes = 0;
  std::optional<double> spacing; // of the points of the largest thick plane
  for (std::size_t i = 0; i < candidates.size(); ++i)
    if (thicknesses[i].factor() > thick_factor) {
      on_thick_planes += candidates[i].inliers.size();
      spacing = spacing.value_or (thicknesses[i].spacing);
    }
  const double thick_share = fraction (on_thick_planes, on_planes, 0.0);
  if (thick_share < min_thick_share)
    return "";
  // On a surface, about four points are in a voxel of twice their spacing.
  constexpr double voxel_size_in_spacings = 2.0;
  return concatenate ("planes are thick: ",
                      std::lrint (100.0 * thick_share),
                      " % of the points on planes are on planes that are more than ",
                      thick_factor,
                      " times thicker than their surroundings: give --voxel-size ",
                      roundedToOneDigit (voxel_size_in_spacings * *spacing),
                      ", or more for larger planes");
}

} // namespace pcl_ops::apps
