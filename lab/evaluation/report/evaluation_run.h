// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <evaluation/detectors/detectors.h>

#include <iosfwd>
#include <optional>

namespace pcl_ops::evaluation {

/** What a run of \ref evaluate does. */
struct EvaluationPlan {
  std::string file; // results.csv, which gets a row for each cloud and configuration
  std::vector<CloudSource> clouds;
  std::vector<Configuration> configurations;
  TruthParameters truth;
  /** Each cloud sets its own up axis, image and names. */
  RunSettings settings;
  unsigned time_limit = 600; // of a peer detector on a cloud [s]; 0: no limit
  unsigned jobs = 1;         // number of clouds processed in parallel
  /** Folder of the labeled clouds DATA_SET/CLOUD/CONFIGURATION.pcd of new rows and
   * DATA_SET/CLOUD/truth.pcd. Without configurations only truth.pcd is written. Empty:
   * no files. */
  std::string labels_folder = {};
  /** Added to every point, so that the voxel grid lies elsewhere in the cloud [m]. The
   * data set has another name in results then, as with \ref most_points. */
  Eigen::Vector3f shift = Eigen::Vector3f::Zero();
  /** A larger cloud is sampled at random to this number of points and loses its image.
   * nullopt: clouds keep all points. */
  std::optional<std::size_t> most_points = std::nullopt;
  /** Whether detectors also run on changed copies of each cloud (\ref cloud_changes),
   * and rows say how far the labels agree. Left out are detectors that need an image,
   * and \ref ownLabels. */
  bool runs_on_changes = false;
};

/** Counts over a call of \ref evaluate. */
struct EvaluationSummary {
  /** Clouds that could be loaded, and those whose rows were all in the file before. */
  std::size_t clouds = 0;
  std::size_t new_rows = 0;
  std::size_t broken_clouds = 0; // clouds that could not be loaded
  std::size_t failed_runs = 0;   // threw an exception, or a signal ended them; no row
  /** Runs that the time limit ended. The row has the limit as detection_ms, and no
   * metrics. */
  std::size_t stopped_runs = 0;
};

/** Runs each configuration on each cloud, unless the CSV file has the row already.
 * \ref ownLabels get a new row each time; the last row counts. Clouds that cannot be
 * loaded and detectors that fail are reported and counted; the other runs go on.
 * Each row is written in one piece as soon as its run ends, so that a stop loses no
 * finished row. An incomplete last line of an interrupted run is removed.
 * \param[out] messages progress, and a line for each cloud or run that failed
 * \param[in] is_terminal whether \p messages is a terminal, which shows the progress in
 * place
 * \throw apps::WorkError if the file cannot be written, or has other columns */
EvaluationSummary
evaluate (const EvaluationPlan& plan, std::ostream& messages, bool is_terminal);

} // namespace pcl_ops::evaluation
