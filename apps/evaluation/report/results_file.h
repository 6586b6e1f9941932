// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <evaluation/detectors/detectors.h>
#include <evaluation/metrics/metrics.h>

#include <fstream>
#include <mutex>
#include <set>
#include <string>
#include <tuple>
#include <vector>

namespace pcl_ops::evaluation {

/** \brief One configuration on one cloud: a row of the results. */
struct ResultRow {
  std::string data_set;
  std::string cloud;
  /** \brief How the truth was had, see \ref truthName. */
  std::string truth;
  std::string configuration;
  std::uint32_t seed = 0;
  /** \brief In the order of \ref valueColumns. */
  std::vector<double> values;

  using Key =
      std::tuple<std::string, std::string, std::string, std::string, std::uint32_t>;

  /** \brief What tells rows apart. */
  Key
  key () const
  {
    return {data_set, cloud, truth, configuration, seed};
  }

  /** \brief
   * \throw std::out_of_range for an unknown column */
  double
  value (const std::string& column) const;
};

/** \brief Names of a row's numbers: points, numbers of planes, \ref namedMetrics, the
 * stages' times [ms], \ref off_planes_name and \ref namedCounts. */
const std::vector<std::string>&
valueColumns ();

std::vector<double>
valuesOf (const Metrics& metrics, const DetectorRun& run);

/** \brief A CSV file of rows that grows row by row: each is written at once and whole,
 * so that a stop loses none, and what is there is not computed again. */
class ResultsFile {
public:
  /** \brief Opens the file for more rows and reads those it has; makes it if there is
   * none. A last line that an interruption left incomplete is removed.
   * \throw apps::WorkError if that fails or the file has other columns */
  explicit ResultsFile (const std::string& file);

  bool
  has (const ResultRow::Key& key) const;

  /** \brief Appends a row. May be called by several threads.
   * \throw apps::WorkError if it cannot be written */
  void
  add (const ResultRow& row);

  const std::vector<ResultRow>&
  rows () const
  {
    return rows_;
  }

private:
  void
  readRows (const std::string& text);

  std::string file_;
  std::ofstream stream_;
  std::vector<ResultRow> rows_;
  std::set<ResultRow::Key> keys_;
  mutable std::mutex mutex_;
};

} // namespace pcl_ops::evaluation
