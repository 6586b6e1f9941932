// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "results_file.h"

#include <map>

namespace pcl_ops::evaluation {

/** \brief The rows of one configuration on one data set, averaged over its clouds. */
struct ConfigurationSummary {
  std::string configuration;
  std::size_t clouds = 0;
  std::map<std::string, double> mean;
};

/** \brief The results on one data set under one kind of truth. */
struct DataSetSummary {
  std::string data_set;
  std::string truth;
  /** \brief In the order of \ref allConfigurations, others behind. */
  std::vector<ConfigurationSummary> configurations;

  /** \brief Null where it has no row. */
  const ConfigurationSummary*
  find (const std::string& configuration) const;
};

/** \brief Averages rows by data set, truth and configuration, whatever their order. */
std::vector<DataSetSummary>
summarize (const std::vector<ResultRow>& rows);

} // namespace pcl_ops::evaluation
