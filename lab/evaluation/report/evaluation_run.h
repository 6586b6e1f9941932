// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <evaluation/detectors/detectors.h>

#include <iosfwd>
#include <optional>

namespace pcl_ops::evaluation {

struct EvaluationPlan {
  std::string file; // of the rows
  std::vector<CloudSource> clouds;
  std::vector<Configuration> configurations;
  TruthParameters truth;
  /** All but the up axis and the image, which are those of the clouds. */
  RunSettings settings;
  unsigned time_limit = 600; // of a detector of others on a cloud [s]; 0: none
  unsigned jobs = 1;         // clouds at a time
  /** For DATA_SET/CLOUD/CONFIGURATION.pcd of new rows, and truth.pcd, which is all that
   * is done without configurations; empty: none. */
  std::string labels_folder = {};
  /** Added to every point: voxels begin elsewhere in the same cloud [m]. */
  Eigen::Vector3f shift = Eigen::Vector3f::Zero();
  /** Of each cloud, drawn at random; none: all. Then none has an image. */
  std::optional<std::size_t> most_points = std::nullopt;
  /** Also runs detectors that need no image on \ref cloud_changes of each cloud, and
   * writes how far their labels agree. */
  bool has_changes = false;
};

/** Clouds count with all their rows in the file; stopped runs have a row without
 * metrics. */
struct EvaluationSummary {
  std::size_t clouds = 0, new_rows = 0;
  std::size_t broken_clouds = 0, failed_runs = 0, stopped_runs = 0;
};

/** Runs every configuration on every cloud for which a CSV file has no row yet; one's
 * own labels get another row each time, of which the last counts. Clouds
 * that cannot be loaded and detectors that fail are said and counted, the rest goes on.
 * The file gets each row at once and whole, as soon as it is known, so that a stop
 * loses none; a last line that an interruption left incomplete is removed.
 * \param[out] messages progress, and a line for each cloud or run that failed
 * \throw apps::WorkError if the file cannot be written, or has other columns */
EvaluationSummary
evaluate (const EvaluationPlan& plan, std::ostream& messages, bool is_terminal);

} // namespace pcl_ops::evaluation
