// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cli/command_line.h>
#include <evaluation/truth/truth.h>

namespace pcl_ops::evaluation {

/** \brief What the commands over data sets have in common: the data sets, the truth and
 * where it is kept. */
struct DataOptions {
  std::vector<std::string> data_sets;
  Eigen::Vector3f up = Eigen::Vector3f::UnitZ();
  TruthParameters truth;
};

/** \brief Declares the data sets as the command's last arguments, and the options. */
void
addDataOptions (apps::CommandLine& line, DataOptions& options);

/** \brief The data sets the options name.
 * \throw as \ref dataSetOf */
std::vector<DataSet>
dataSetsOf (const DataOptions& options);

} // namespace pcl_ops::evaluation
