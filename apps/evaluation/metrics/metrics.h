// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "instance_metrics.h"
#include "size_classes.h"
#include <evaluation/labels/labels.h>

#include <string>
#include <utility>

namespace pcl_ops::evaluation {

/** \brief Everything said about a segmentation against the truth. */
struct Metrics {
  /** \brief Points with the right one of the three classes / points. */
  double classification_accuracy = 0.0;
  /** \brief Points on true planes with the label assigned to theirs / such points. */
  double segmentation_accuracy = 0.0;
  /** \brief The same over all points; on no plane in both is right, too. */
  double segmentation_accuracy_all = 0.0;
  /** \brief Points on no true plane that the result has on one / such points. */
  double points_off_planes_called_planes = 0.0;
  InstanceMetrics at_50;
  InstanceMetrics at_75;
  std::size_t points = 0;
  std::size_t truth_planes = 0;
  std::size_t result_planes = 0;
  /** \brief How many of the true planes are found, by number of points. */
  SizeClasses by_size = sizeClasses ({});
  /** \brief The same by width, see \ref widthsOf. */
  SizeClasses by_width = widthClasses ({}, {});
};

/** \brief Published name of \ref Metrics::points_off_planes_called_planes; as a column
 * of results it is behind the times, so that the others stay where they were. */
constexpr const char* off_planes_name = "points_off_planes_called_planes";

/** \brief Compares two labelings of a cloud. Points without finite coordinates are on
 * no surface and do not count.
 * \param[in] cloud the points
 * \param[in] truth, result their labels, each of the cloud's size
 * \throw std::invalid_argument if the sizes differ
 * \throw std::length_error as \ref assignPlanes */
Metrics
compareLabels (const XyzCloud& cloud,
               const PlaneLabels& truth,
               const PlaneLabels& result,
               const ClassParameters& parameters = {});

/** \brief The fractions of a comparison but \ref off_planes_name under their published
 * names, in order: the three accuracies, then the instance metrics at 0.5 and, with
 * suffix _75, at 0.75. */
std::vector<std::pair<std::string, double>>
namedMetrics (const Metrics& metrics);

/** \brief The numbers of true planes, and of those found, by number of points and by
 * width, under their published names: "found_75_by_width_below_0.03". */
std::vector<std::pair<std::string, double>>
namedCounts (const Metrics& metrics);

} // namespace pcl_ops::evaluation
