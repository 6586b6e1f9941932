// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/PointIndices.h>

#include <pcl_ops/plane.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace pcl_ops::evaluation {

using Eigen::Vector3d;
using XyzCloud = pcl::PointCloud<pcl::PointXYZ>;

/** Of each point of a cloud; 0: on no plane. */
using PlaneLabels = std::vector<std::uint32_t>;

/** Labels 1 .. P of the points of disjoint planes. */
PlaneLabels
labelsOf (const std::vector<pcl::PointIndices>& planes, std::size_t points);

/** Of the points that have coordinates. */
pcl::Indices
finitePointsOf (const XyzCloud& cloud);

PlaneLabels
selectLabels (const PlaneLabels& labels, const pcl::Indices& points);

/** Labels renumbered without gaps, so that a plane is an index into a vector. */
struct PlaneIds {
  std::vector<std::uint32_t> label; // of each plane: those in use, ascending, without 0
  std::vector<std::size_t> points;  // number of those of each plane
  std::vector<std::uint32_t> of_point; // the plane of each; none for label 0

  static constexpr std::uint32_t none = ~std::uint32_t (0);

  std::size_t
  size () const
  {
    return label.size();
  }
};

PlaneIds
planeIds (const PlaneLabels& labels);

/** The paper's "small planes, with under 50 points, are labeled as other" (IV-A). */
void
dropSmallPlanes (PlaneLabels& labels, std::size_t min_points);

/** Adds a point in the frame of the origin of the moments. */
inline void
addTo (Moments& moments, const Vector3d& point)
{
  const Vector3d local = point - moments.origin;
  moments.add (local.x(), local.y(), local.z());
}

/** How planes are divided into the paper's three classes. */
struct ClassParameters {
  Vector3d up = Vector3d::UnitZ();          // against gravity, of length 1
  double tolerance = paper_angle_tolerance; // [rad]
};

/** Least squares through all finite points of a label, normals to the sensor's side;
 * class Other where they span no plane. */
std::vector<PlaneSegment>
planesOf (const XyzCloud& cloud, const PlaneIds& ids, const ClassParameters& classes);

/** What a true plane and a found plane have in common. */
struct Overlap {
  std::uint32_t truth, result;
  std::size_t points;
};

/** How two labelings of the same points meet: only pairs that do are stored. */
struct Confusion {
  PlaneIds truth, result;
  /** By truth, then by result. */
  std::vector<Overlap> overlaps = {};
  std::size_t points_on_no_plane_in_both = 0;
  /** Points on no true plane. */
  std::size_t points_off_planes = 0;

  /** Intersection over union. */
  double
  iou (const Overlap& overlap) const
  {
    const std::size_t both =
        truth.points[overlap.truth] + result.points[overlap.result] - overlap.points;
    return double (overlap.points) / double (both);
  }
};

Confusion
confusionOf (const PlaneLabels& truth, const PlaneLabels& result);

using NamedValues = std::vector<std::pair<std::string, double>>;

/** True planes of about the same size, a number of points or a width [m], and how many
 * are matched at an intersection over union of 0.5 and of 0.75. */
struct SizeClass {
  double from = 0.0;
  std::optional<double> below = std::nullopt; // none for the largest
  std::size_t planes = 0, found_50 = 0, found_75 = 0;
};

/** Smallest first. */
using SizeClasses = std::vector<SizeClass>;

struct Metrics {
  std::size_t points = 0, truth_planes = 0, result_planes = 0;
  /** Under their published names, in order, which the page on accuracy defines: three
   * accuracies, then metrics of planes as instances at an intersection over union of
   * 0.5 and, with suffix _75, at 0.75. Where both sides have no plane the result is
   * perfect, where one has none it has found nothing. Then the points on no true plane
   * that the result has on one / such points, and \ref partitionMetrics. */
  NamedValues named = {};
  /** By number of points. */
  SizeClasses by_size = {};
  /** The width is the smaller side of the rectangle whose points, spread evenly, have
   * the variance of the plane's along its second axis, sqrt (12 variance); 0 where the
   * points span no plane. A plane that is partly hidden is as wide as what is seen of
   * it. */
  SizeClasses by_width = {};
};

/** Points without finite coordinates do not count, nor those whose truth is unknown; a
 * found plane counts if at least half of its points are known.
 * \param[in] is_ignored of each point, whether its truth is unknown; empty: none
 * \throw std::invalid_argument if the sizes differ
 * \throw std::length_error for more labels than any segmentation into planes has */
Metrics
compareLabels (const XyzCloud& cloud,
               const PlaneLabels& truth,
               const PlaneLabels& result,
               const ClassParameters& parameters = {},
               const std::vector<char>& is_ignored = {});

/** Of \ref SizeClasses by their published names, "found_75_by_width_below_0.03". */
NamedValues
namedCounts (const Metrics& metrics);

} // namespace pcl_ops::evaluation
