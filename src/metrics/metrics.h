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

/** Returns labels 1 .. P for the points of P disjoint planes, and 0 for all others.
 * \param[in] planes indices of points, all from 0 to \p points - 1
 * \param[in] points number of points of the cloud */
PlaneLabels
labelsOf (const std::vector<pcl::PointIndices>& planes, std::size_t points);

/** Returns the indices of the points with finite coordinates. */
pcl::Indices
finitePointsOf (const XyzCloud& cloud);

/** Returns the labels of the points with these indices. */
PlaneLabels
selectLabels (const PlaneLabels& labels, const pcl::Indices& points);

/** Ids 0 .. P - 1 of P planes, as indices of vectors: labels may have gaps. */
struct PlaneIds {
  /** The label of each plane, ascending: all labels of points except 0. */
  std::vector<std::uint32_t> label;
  /** Number of points of each plane. */
  std::vector<std::size_t> points;
  /** The id of each point's plane; \ref none for label 0. */
  std::vector<std::uint32_t> of_point;

  static constexpr std::uint32_t none = ~std::uint32_t (0);

  /** Number of planes. */
  std::size_t
  size () const
  {
    return label.size();
  }
};

/** Numbers the planes of a labeling by ascending labels. */
PlaneIds
planeIds (const PlaneLabels& labels);

/** Sets the labels of planes with fewer than \p min_points points to 0. The paper:
 * "small planes, with under 50 points, are labeled as other" (IV-A). */
void
dropSmallPlanes (PlaneLabels& labels, std::size_t min_points);

/** Adds a point to moments; it and Moments::origin are in the same frame. */
inline void
addTo (Moments& moments, const Vector3d& point)
{
  const Vector3d from_origin = point - moments.origin;
  moments.add (from_origin.x(), from_origin.y(), from_origin.z());
}

/** Parameters for classifying planes into the paper's three orientations. */
struct ClassParameters {
  Vector3d up = Vector3d::UnitZ(); // unit vector against gravity
  /** Largest angle of a horizontal plane to the horizontal, and of a vertical plane to
   * \ref up [rad]. */
  double tolerance = paper_angle_tolerance;
};

/** Fits a least squares plane to all points of each label. Normals point to the side of
 * the sensor's position in \p cloud. If the points of a label span no plane, its
 * orientation is Other.
 * \param[in] cloud its points with a label must be finite
 * \param[in] ids has one PlaneIds::of_point for each point of \p cloud
 * \return a plane for each id */
std::vector<PlaneSegment>
planesOf (const XyzCloud& cloud, const PlaneIds& ids, const ClassParameters& classes);

/** A true plane and a found plane with common points. */
struct Overlap {
  std::uint32_t truth, result; // ids of both planes
  std::size_t points;          // number of common points
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
  std::size_t points_off_true_planes = 0;

  /** Intersection over union of both planes, in points. */
  double
  iou (const Overlap& overlap) const
  {
    const std::size_t points_of_union =
        truth.points[overlap.truth] + result.points[overlap.result] - overlap.points;
    return double (overlap.points) / double (points_of_union);
  }
};

/** Counts the points that two labelings of the same points have in common.
 * \param[in] truth,result a label for each point, in the same order */
Confusion
confusionOf (const PlaneLabels& truth, const PlaneLabels& result);

/** Names with their values, in the order of a report. */
using NamedValues = std::vector<std::pair<std::string, double>>;

/** True planes of similar size. The size is a number of points or a width [m]. */
struct SizeClass {
  /** The sizes of the class: from \ref from on, and less than \ref below; the class of
   * the largest planes has no upper limit. */
  double from = 0.0;
  std::optional<double> below = std::nullopt;
  /** Number of true planes of the class. */
  std::size_t planes = 0;
  /** How many of them are matched at an intersection over union (IoU) of 0.5, and how
   * many at 0.75. */
  std::size_t found_50 = 0, found_75 = 0;
};

/** Classes of all sizes from 0 on, the smallest first. */
using SizeClasses = std::vector<SizeClass>;

/** The metrics of a result. */
struct Metrics {
  std::size_t points = 0;        // that count
  std::size_t truth_planes = 0;  // number of true planes
  std::size_t result_planes = 0; // number of found planes that count
  /** Metrics under their published names; the page on accuracy defines them. In order:
   * three accuracies; metrics of planes as instances, at an intersection over union of
   * 0.5 and, with suffix _75, at 0.75; of the points on no true plane, the share that
   * is on a found plane; \ref partitionMetrics. If neither truth nor result has a
   * plane, the result is perfect. If only one of them has planes, precision and recall
   * are 0. */
  NamedValues named = {};
  /** True planes by number of points. */
  SizeClasses by_size = {};
  /** True planes by width: the smaller side of a rectangle of evenly spread points that
   * has the variances of the plane's points, sqrt (12 variance); 0 if these points span
   * no plane. So only the visible part of a plane counts. */
  SizeClasses by_width = {};
};

/** Computes all metrics of a result against the true labels. Points with a NaN or
 * infinite coordinate or unknown truth do not count. A found plane counts if the truth
 * is known for at least half of its points.
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
