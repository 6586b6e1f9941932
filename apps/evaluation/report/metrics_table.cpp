// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "metrics_table.h"

#include <io/output_file.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>
#include <sstream>

namespace pcl_ops::evaluation {

namespace {

/** A column of the table: the mean of a column of the results. */
struct Column {
  const char* header;
  const char* name;
  /** On the number of the results. */
  double factor;
  int decimals;
};

constexpr double per_cent = 100.0, seconds = 1e-3;
constexpr Column columns[] = {
    {"class. %", "classification_accuracy", per_cent, 2},
    {"segm. %", "segmentation_accuracy", per_cent, 2},
    {"all points %", "segmentation_accuracy_all", per_cent, 2},
    {"F 0.5", "f_score", 1.0, 3},
    {"F 0.75", "f_score_75", 1.0, 3},
    {"precision", "precision", 1.0, 3},
    {"recall", "recall", 1.0, 3},
    {"mean IoU", "mean_iou", 1.0, 3},
    {"PQ", "panoptic_quality", 1.0, 3},
    {"over", "over_segmentation", 1.0, 3},
    {"under", "under_segmentation", 1.0, 3},
    {"noise", "noise", 1.0, 3},
    {"missed", "missed", 1.0, 3},
    {"total s", "detection_ms", seconds, 4},
    {"off planes %", off_planes_name, per_cent, 2}};

using Rows = std::vector<const ResultRow*>;

/** Position among all configurations; unknown ones come last. */
std::size_t
rankOf (const std::string& configuration)
{
  const std::vector<Configuration>& all = allConfigurations();
  const auto found =
      std::find_if (all.begin(), all.end(), [&] (const Configuration& known) {
        return known.name == configuration;
      });
  return static_cast<std::size_t> (found - all.begin());
}

std::vector<std::string>
cellsOf (Rows rows)
{
  // Sums of floating point numbers depend on their order; that of the file depends on
  // which thread was first.
  std::sort (rows.begin(), rows.end(), [] (const ResultRow* a, const ResultRow* b) {
    return a->key() < b->key();
  });
  std::vector<std::string> cells{rows.front()->configuration,
                                 std::to_string (rows.size())};
  for (const Column& column : columns) {
    double sum = 0.0;
    for (const ResultRow* row : rows)
      sum += row->value (column.name);
    cells.push_back (decimal (column.factor * (sum / static_cast<double> (rows.size())),
                              column.decimals));
  }
  return cells;
}

} // namespace

std::vector<TextTable>
metricsTables (const std::vector<ResultRow>& rows)
{
  using ByConfiguration = std::map<std::pair<std::size_t, std::string>, Rows>;
  std::map<std::pair<std::string, std::string>, ByConfiguration> groups;
  for (const ResultRow& row : rows)
    groups[{row.data_set, row.truth}][{rankOf (row.configuration), row.configuration}]
        .push_back (&row);

  std::vector<TextTable> tables;
  for (const auto& [name, configurations] : groups) {
    TextTable table{
        name.first + ", truth " + name.second, {"configuration", "clouds"}, {}};
    for (const Column& column : columns)
      table.header.emplace_back (column.header);
    for (const auto& [configuration, of_configuration] : configurations)
      table.rows.push_back (cellsOf (of_configuration));
    tables.push_back (table);
  }
  return tables;
}

void
writeMetricsTables (const std::vector<ResultRow>& rows, const std::string& folder)
{
  std::ostringstream text;
  for (const TextTable& table : metricsTables (rows))
    text << table;
  apps::writeTextFile ((std::filesystem::path (folder) / "tables.md").string(),
                       text.str());
  std::cout << text.str();
}

} // namespace pcl_ops::evaluation
