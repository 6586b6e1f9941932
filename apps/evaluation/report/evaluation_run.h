// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <evaluation/detectors/detectors.h>

#include <iosfwd>

namespace pcl_ops::evaluation {

/** \brief What to run over what. */
struct EvaluationPlan {
  std::vector<CloudSource> clouds;
  std::vector<Configuration> configurations;
  TruthParameters truth;
  /** \brief All but the up axis and the image, which are those of the clouds. */
  RunSettings settings;
  /** \brief Of a detector of others on a cloud [s]; 0: none. */
  unsigned time_limit = 600;
  /** \brief Clouds at a time; only 1 leaves the measured times undisturbed. */
  unsigned jobs = 1;
  /** \brief Where the labels of each new row and the truth become
   * DATA_SET/CLOUD/CONFIGURATION.pcd and truth.pcd; empty: nowhere. */
  std::string labels_folder = {};
};

/** \brief What became of it. */
struct EvaluationSummary {
  /** \brief Clouds with all their rows in the file. */
  std::size_t clouds = 0;
  std::size_t new_rows = 0;
  std::size_t broken_clouds = 0;
  /** \brief Configurations that failed on a cloud, or took too long: those have a row
   * without metrics. */
  std::size_t failed_runs = 0, stopped_runs = 0;
};

/** \brief Runs every configuration on every cloud for which a CSV file has no row yet.
 * Clouds that cannot be loaded and detectors that fail are said and counted, the rest
 * goes on.
 * \param[in] file gets each row at once and whole, as soon as it is known, so that a
 * stop loses none; a last line that an interruption left incomplete is removed
 * \param[out] messages progress, and a line for each cloud or run that failed
 * \param[in] is_terminal whether \p messages is one
 * \throw apps::WorkError if the file cannot be written, or has other columns */
EvaluationSummary
evaluate (const EvaluationPlan& plan,
          const std::string& file,
          std::ostream& messages,
          bool is_terminal);

} // namespace pcl_ops::evaluation
