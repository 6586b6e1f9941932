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

/** The plane label of each point of a cloud; 0: on no plane. */
using PlaneLabels = std::vector<std::uint32_t>;

/** Returns labels 1 .. P for the points of P disjoint planes, and 0 for all others. */
PlaneLabels
labelsOf (const std::vector<pcl::PointIndices>& planes, std::size_t points);

/** Returns the indices of the points with finite coordinates. */
pcl::Indices
finitePointsOf (const XyzCloud& cloud);

/** Returns the labels of the points of these indices. */
PlaneLabels
selectLabels (const PlaneLabels& labels, const pcl::Indices& points);

/** Labels renumbered without gaps to ids 0 .. P - 1, so that ids index vectors. */
struct PlaneIds {
  std::vector<std::uint32_t>
      label; // of each plane: all labels in use except 0, ascending
  std::vector<std::size_t> points;     // number of points of each plane
  std::vector<std::uint32_t> of_point; // id of each point's plane; none for label 0

  static constexpr std::uint32_t none = ~std::uint32_t (0);

  std::size_t
  size () const
  {
    return label.size();
  }
};

PlaneIds
planeIds (const PlaneLabels& labels);

/** Sets labels with fewer than \p min_points points to 0. The paper: "small planes,
 * with under 50 points, are labeled as other" (IV-A). */
void
dropSmallPlanes (PlaneLabels& labels, std::size_t min_points);

/** Adds a point to moments. The point is in the frame of Moments::origin. */
inline void
addTo (Moments& moments, const Vector3d& point)
{
  const Vector3d local = point - moments.origin;
  moments.add (local.x(), local.y(), local.z());
}

/** Parameters for classifying planes into the paper's three orientations. */
struct ClassParameters {
  Vector3d up = Vector3d::UnitZ();          // unit vector against gravity
  double tolerance = paper_angle_tolerance; // [rad]
};

/** Fits a least squares plane to all points of each label. Normals point to the
 * sensor's side. If the points of a label span no plane, its orientation is Other.
 * \param[in] ids has one PlaneIds::of_point for each point of \p cloud
 * \param[in] cloud its points with a label must be finite */
std::vector<PlaneSegment>
planesOf (const XyzCloud& cloud, const PlaneIds& ids, const ClassParameters& classes);

/** Number of common points of a true plane and a found plane (ids). */
struct Overlap {
  std::uint32_t truth, result;
  std::size_t points;
};

/** Sparse confusion matrix of two labelings of the same points: only pairs of planes
 * with common points are stored. */
struct Confusion {
  PlaneIds truth, result;
  /** Sorted by truth, then by result. */
  std::vector<Overlap> overlaps = {};
  /** Number of points on neither a true nor a found plane. */
  std::size_t points_on_no_plane_in_both = 0;
  /** Number of points on no true plane. */
  std::size_t points_off_planes = 0;

  /** Intersection over union. */
  double
  iou (const Overlap& overlap) const
  {
    const std::size_t points_of_union =
        truth.points[overlap.truth] + result.points[overlap.result] - overlap.points;
    return double (overlap.points) / double (points_of_union);
  }
};

Confusion
confusionOf (const PlaneLabels& truth, const PlaneLabels& result);

using NamedValues = std::vector<std::pair<std::string, double>>;

/** True planes of similar size, a number of points or a width [m], and how many of them
 * are matched at an intersection over union (IoU) of 0.5 and of 0.75. */
struct SizeClass {
  /** Sizes from \ref from on, and less than \ref below; the largest class has no upper
   * limit. */
  double from = 0.0;
  std::optional<double> below = std::nullopt;
  std::size_t planes = 0, found_50 = 0, found_75 = 0;
};

/** Smallest first. */
using SizeClasses = std::vector<SizeClass>;

/** The metrics of a result. */
struct Metrics {
  std::size_t points = 0, truth_planes = 0, result_planes = 0;
  /** Metrics under their published names; the page on accuracy defines them. In order:
   * three accuracies; instance metrics of planes at an intersection over union of 0.5
   * and, with suffix _75, at 0.75; the share of points off all true planes that the
   * result has on a plane; \ref partitionMetrics. If neither side has a plane, the
   * result is perfect. If only one side has planes, precision and recall are 0. */
  NamedValues named = {};
  /** True planes by number of points. */
  SizeClasses by_size = {};
  /** True planes by width, the smaller side of a rectangle of evenly spread points with
   * the plane's variance along its second axis: sqrt (12 variance); 0 if the points
   * span no plane. Only the visible part of a plane counts. */
  SizeClasses by_width = {};
};

/** Computes all metrics of a result against the true labels. Points with non-finite
 * coordinates or unknown truth do not count. A found plane counts if the truth is known
 * for at least half of its points.
 * \param[in] is_ignored for each point, whether its truth is unknown; empty: all known
 * \throw std::invalid_argument if the sizes differ
 * \throw std::length_error for more than 10^8 pairs of a true and a found label */
Metrics
compareLabels (const XyzCloud& cloud,
               const PlaneLabels& truth,
               const PlaneLabels& result,
               const ClassParameters& parameters = {},
               const std::vector<char>& is_ignored = {});

/** Returns the counts of all \ref SizeClasses under their published names, as
 * "found_75_by_width_below_0.03". */
NamedValues
namedCounts (const Metrics& metrics);

} // namespace pcl_ops::evaluation
