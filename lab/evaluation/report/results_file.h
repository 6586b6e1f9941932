// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <evaluation/data/changed_clouds.h>

#include <fstream>
#include <map>
#include <mutex>
#include <set>
#include <string>

namespace pcl_ops::evaluation {

/** The numbers of a row of results.csv by column. A column that is missing here is NaN
 * in the file. */
using RowNumbers = std::map<std::string, double>;

/** Returns the name of the column of the agreement under a change. */
std::string
agreementColumn (const CloudChange& change);

/** Returns a cell of RFC 4180, quoted if needed, and a comma. A line break becomes a
 * space, so that each row is one line. */
std::string
csvCell (std::string text);

/** The file results.csv; its lines are kept in memory as well. The functions \ref has
 * and \ref add are thread-safe. */
class ResultsFile {
public:
  /** Reads the rows that the file has and removes an incomplete last line.
   * \throw apps::WorkError if the file has other columns or cannot be written */
  explicit ResultsFile (const std::string& file);

  /** \param[in] first_cells as those of \ref add
   * \return whether there is a row that begins with these cells */
  bool
  has (const std::string& first_cells) const;

  /** Writes a row.
   * \param[in] first_cells data set, cloud, truth, configuration and seed, each as
   * \ref csvCell
   * \throw apps::OutputError if there is no room; the file is then as before */
  void
  add (const std::string& first_cells, const RowNumbers& numbers);

private:
  std::string file_;
  std::ofstream stream_;
  std::set<std::string> lines_;
  mutable std::mutex mutex_;
};

} // namespace pcl_ops::evaluation
