// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <string>
#include <vector>

namespace pcl_ops::evaluation {

/** \brief What the paper reports of a configuration (Sun & Mordohai, ICRA 2019, Tables
 * I to IV and section IV-B): SUN RGB-D, Intel Core i7-7700, one thread. NaN: not given.
 */
struct PaperFigures {
  /** \brief As in \ref allConfigurations. */
  std::string configuration;
  double classification_accuracy = NAN;
  /** \brief Times [s]: before merging, merging, and in total. */
  double detection = NAN;
  double merging = NAN;
  double total = NAN;
  double segmentation_accuracy = NAN;
  double planes_before_merging = NAN;
  double planes = NAN;
};

/** \brief Planes in the paper's truth per cloud. */
constexpr double paper_truth_planes = 25.38;

/** \brief The figures of a configuration; all NaN where the paper has none. */
PaperFigures
paperFiguresOf (const std::string& configuration);

} // namespace pcl_ops::evaluation
