// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/PointIndices.h>

#include <io/shifted_cloud.h>
#include <pcl_ops/plane.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace pcl_ops::evaluation {

using apps::XyzCloud;

/** \brief The plane of each point of a cloud; 0: on no plane. */
using PlaneLabels = std::vector<std::uint32_t>;

/** \brief Labels 1 .. P of the points of disjoint planes. */
PlaneLabels
labelsOf (const std::vector<pcl::PointIndices>& planes, std::size_t points);

/** \brief Indices of the points of a cloud that have coordinates. */
pcl::Indices
finitePointsOf (const XyzCloud& cloud);

/** \brief The labels of some of the points. */
PlaneLabels
selectLabels (const PlaneLabels& labels, const pcl::Indices& points);

/** \brief Labels renumbered without gaps, so that a plane is an index into a vector. */
struct PlaneIds {
  /** \brief The labels in use, ascending, without 0. */
  std::vector<std::uint32_t> label;
  /** \brief Number of points of each plane. */
  std::vector<std::size_t> points;
  /** \brief Position in \ref label of each point's plane; none for label 0. */
  std::vector<std::uint32_t> of_point;

  static constexpr std::uint32_t none = ~std::uint32_t (0);

  std::size_t
  size () const
  {
    return label.size();
  }
};

PlaneIds
planeIds (const PlaneLabels& labels);

/** \brief Sets the labels of planes with fewer than \p min_points points to 0: the
 * paper's "small planes, with under 50 points, are labeled as other" (section IV-A). */
void
dropSmallPlanes (PlaneLabels& labels, std::size_t min_points);

/** \brief Adds a point in the frame of the origin of the moments. */
inline void
addTo (Moments& moments, const Eigen::Vector3d& point)
{
  const Eigen::Vector3d local = point - moments.origin;
  moments.add (local.x(), local.y(), local.z());
}

/** \brief How planes are divided into the paper's three classes. */
struct ClassParameters {
  /** \brief Unit vector against gravity in the cloud's frame. */
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  /** \brief Largest deviation from horizontal or vertical [rad]. */
  double tolerance = paper_angle_tolerance;
};

/** \brief The planes of labeled points: least squares through all points of a label,
 * normals to the sensor's side.
 * \param[in] cloud finite points with the sensor's origin
 * \return a plane per id; class Other where the points of a label span none */
std::vector<PlaneSegment>
planesOf (const XyzCloud& cloud,
          const PlaneIds& planes,
          const ClassParameters& parameters);

/** \brief Number of points a true plane and a found plane have in common. */
struct Overlap {
  std::uint32_t truth, result;
  std::size_t points;
};

/** \brief How two labelings of the same points meet: only pairs that do are stored. */
struct Confusion {
  PlaneIds truth, result;
  /** \brief By truth, then by result; ids as in \ref truth and \ref result. */
  std::vector<Overlap> overlaps = {};
  std::size_t points_on_no_plane_in_both = 0;
  /** \brief Points on no true plane. */
  std::size_t points_off_planes = 0;

  /** \brief Intersection over union of the two planes of an overlap. */
  double
  iou (const Overlap& overlap) const
  {
    const std::size_t both =
        truth.points[overlap.truth] + result.points[overlap.result] - overlap.points;
    return static_cast<double> (overlap.points) / static_cast<double> (both);
  }
};

/** \param[in] truth, result labels of the same points: of equal size */
Confusion
confusionOf (const PlaneLabels& truth, const PlaneLabels& result);

using NamedValues = std::vector<std::pair<std::string, double>>;

/** \brief True planes of about the same size, a number of points or a width [m], and
 * how many are matched at an intersection over union of 0.5 and of 0.75. */
struct SizeClass {
  double from = 0.0;
  /** \brief The class above begins here; none for the largest planes. */
  std::optional<double> below = std::nullopt;
  std::size_t planes = 0, found_50 = 0, found_75 = 0;
};

/** \brief Smallest first. */
using SizeClasses = std::vector<SizeClass>;

/** \brief Everything said about a segmentation against the truth. */
struct Metrics {
  std::size_t points = 0, truth_planes = 0, result_planes = 0;
  /** \brief Fractions under their published names, in order, which the page on accuracy
   * defines: three accuracies, then metrics of planes as instances at an intersection
   * over union of 0.5 and, with suffix _75, at 0.75. Where both sides have no plane the
   * result is perfect, where one has none it has found nothing. */
  NamedValues named = {};
  /** \brief Points on no true plane that the result has on one / such points. */
  double points_off_planes_called_planes = 0.0;
  /** \brief True planes by number of points: below 200, 500, 1000, 3000, 10000, and
   * more. */
  SizeClasses by_size = {};
  /** \brief By width: below 0.03, 0.06, 0.12, 0.25, 1 m, and wider. The width is the
   * smaller side of the rectangle whose points, spread evenly, have the variance of the
   * plane's along its second axis, sqrt (12 variance); 0 where the points span no
   * plane. A plane that is partly hidden is as wide as what is seen of it. */
  SizeClasses by_width = {};
};

/** \brief Published name of \ref Metrics::points_off_planes_called_planes; as a column
 * of results it is behind the times, so that the others stay where they were. */
constexpr const char* off_planes_name = "points_off_planes_called_planes";

/** \brief The largest sum of benefits of a pairing of rows with columns, each used at
 * most once: the Hungarian method by shortest augmenting paths (Kuhn 1955; Jonker &
 * Volgenant 1987), O(rows^2 columns).
 * \param[in] benefit no more rows than columns */
double
maximumAssignment (const Eigen::MatrixXd& benefit);

/** \brief Compares two labelings of a cloud. Points without finite coordinates are on
 * no surface and do not count.
 * \throw std::invalid_argument if the sizes differ
 * \throw std::length_error for more labels than any segmentation into planes has */
Metrics
compareLabels (const XyzCloud& cloud,
               const PlaneLabels& truth,
               const PlaneLabels& result,
               const ClassParameters& parameters = {});

/** \brief The numbers of true planes, and of those found, by number of points and by
 * width, under their published names: "found_75_by_width_below_0.03". */
NamedValues
namedCounts (const Metrics& metrics);

} // namespace pcl_ops::evaluation
