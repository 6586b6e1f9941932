// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <evaluation/detectors/detectors.h>
#include <evaluation/metrics/metrics.h>

#include <fstream>
#include <mutex>
#include <set>
#include <string>

namespace pcl_ops::evaluation {

/** \brief What tells the rows of the results apart: one configuration on one cloud. */
struct ResultKey {
  std::string data_set;
  std::string cloud;
  /** \brief How the truth was had, see \ref truthName. */
  std::string truth;
  std::string configuration;
  std::uint32_t seed = 0;
};

/** \brief The numbers of a row and their columns: points, numbers of planes,
 * \ref Metrics::named, the stages' times [ms], \ref off_planes_name, \ref namedCounts.
 */
NamedValues
namedValues (const Metrics& metrics, const DetectorRun& run);

/** \brief A CSV file of rows that grows row by row: each is written at once and whole,
 * so that a stop loses none, and what is there is not computed again. Its calls may be
 * made by several threads. */
class ResultsFile {
public:
  /** \brief Opens or makes the file. A last line that an interruption left incomplete
   * is removed.
   * \throw apps::WorkError if that fails or the file has other columns */
  explicit ResultsFile (const std::string& file);

  bool
  has (const ResultKey& key) const;

  /** \throw apps::WorkError if the row cannot be written */
  void
  add (const ResultKey& key, const NamedValues& values);

private:
  std::string file_;
  std::ofstream stream_;
  std::set<std::string> lines_;
  mutable std::mutex mutex_;
};

} // namespace pcl_ops::evaluation
