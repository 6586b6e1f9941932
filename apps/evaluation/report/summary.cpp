// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "summary.h"

#include <algorithm>

namespace pcl_ops::evaluation {

namespace {

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

ConfigurationSummary
averageOf (const std::string& configuration, std::vector<const ResultRow*> rows)
{
  // Sums of floating point numbers depend on their order; that of the file depends on
  // which thread was first.
  std::sort (rows.begin(), rows.end(), [] (const ResultRow* a, const ResultRow* b) {
    return a->key() < b->key();
  });
  ConfigurationSummary summary{configuration, rows.size(), {}};
  for (std::size_t column = 0; column < valueColumns().size(); ++column) {
    double sum = 0.0;
    for (const ResultRow* row : rows)
      sum += row->values[column];
    summary.mean[valueColumns()[column]] = sum / static_cast<double> (rows.size());
  }
  return summary;
}

} // namespace

const ConfigurationSummary*
DataSetSummary::find (const std::string& configuration) const
{
  for (const ConfigurationSummary& summary : configurations)
    if (summary.configuration == configuration)
      return &summary;
  return nullptr;
}

std::vector<DataSetSummary>
summarize (const std::vector<ResultRow>& rows)
{
  using RowsByConfiguration = std::map<std::string, std::vector<const ResultRow*>>;
  std::map<std::pair<std::string, std::string>, RowsByConfiguration> groups;
  for (const ResultRow& row : rows)
    groups[{row.data_set, row.truth}][row.configuration].push_back (&row);

  std::vector<DataSetSummary> summaries;
  for (const auto& [name, configurations] : groups) {
    DataSetSummary summary{name.first, name.second, {}};
    for (const auto& [configuration, of_configuration] : configurations)
      summary.configurations.push_back (averageOf (configuration, of_configuration));
    std::stable_sort (
        summary.configurations.begin(),
        summary.configurations.end(),
        [] (const ConfigurationSummary& a, const ConfigurationSummary& b) {
          return rankOf (a.configuration) < rankOf (b.configuration);
        });
    summaries.push_back (summary);
  }
  return summaries;
}

} // namespace pcl_ops::evaluation
