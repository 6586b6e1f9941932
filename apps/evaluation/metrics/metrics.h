// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "instance_metrics.h"
#include "size_classes.h"

namespace pcl_ops::evaluation {

/** \brief Everything said about a segmentation against the truth. */
struct Metrics {
  std::size_t points = 0;
  std::size_t truth_planes = 0;
  std::size_t result_planes = 0;
  /** \brief Fractions under their published names, in order: the three accuracies, then
   * \ref instanceMetrics at 0.5 and, with suffix _75, at 0.75. */
  NamedValues named;
  /** \brief Points on no true plane that the result has on one / such points. */
  double points_off_planes_called_planes = 0.0;
  /** \brief How many of the true planes are found, by number of points, and by width,
   * see \ref widthsOf. */
  SizeClasses by_size, by_width;
};

/** \brief Published name of \ref Metrics::points_off_planes_called_planes; as a column
 * of results it is behind the times, so that the others stay where they were. */
constexpr const char* off_planes_name = "points_off_planes_called_planes";

/** \brief Compares two labelings of a cloud. Points without finite coordinates are on
 * no surface and do not count.
 * \throw std::invalid_argument if the sizes differ
 * \throw std::length_error as \ref assignPlanes */
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
