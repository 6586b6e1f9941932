// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "report.h"

#include "plots.h"
#include "tables.h"
#include <cli/errors.h>
#include <io/output_file.h>

#include <filesystem>
#include <sstream>

namespace pcl_ops::evaluation {

namespace {

namespace fs = std::filesystem;

} // namespace

void
writeReport (const std::vector<ResultRow>& rows,
             const std::string& folder,
             std::ostream& stream)
{
  std::ostringstream text;
  bool all_drawn = true;
  for (const DataSetSummary& summary : summarize (rows)) {
    for (const TextTable& table : tablesOf (summary))
      text << table;
    const fs::path plots = fs::path (folder) / (summary.data_set + "-" + summary.truth);
    std::error_code error;
    if (!fs::create_directories (plots, error) && error)
      throw apps::WorkError (plots.string(), "cannot be made; is a file in the way?");
    all_drawn = writePlots (summary, plots.string()) && all_drawn;
  }
  apps::writeTextFile ((fs::path (folder) / "tables.md").string(), text.str());
  stream << text.str();
  if (!all_drawn)
    stream
        << "No plots were drawn: install gnuplot and run gnuplot on the .gp files in "
        << folder << ".\n";
}

} // namespace pcl_ops::evaluation
