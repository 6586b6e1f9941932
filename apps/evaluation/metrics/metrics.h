// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <evaluation/labels/labels.h>

#include <optional>
#include <string>
#include <utility>

namespace pcl_ops::evaluation {

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
