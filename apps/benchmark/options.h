// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud_measures.h"

namespace pcl_ops::benchmark {

constexpr const char* program_name = "pcl_ops_benchmark";

/** \brief What the command line says. */
struct Options {
  /** \brief As evaluation::dataSetOf takes them; empty with \ref worst_cases. */
  std::string clouds;
  std::string memory_cloud;
  std::string json_file;
  /** \brief Empty: nothing is measured for it. */
  std::string scaling_folder;
  std::string scaling_points = "30000,100000,300000,1000000,3000000,10000000";
  /** \brief Measure worst cases, and nothing else. */
  bool worst_cases = false;
  std::string worst_case_points = "10000,100000,1000000";
  MeasureParameters measures;
};

/** \return false if help or version was printed
 * \throw apps::UsageError */
bool
readOptions (int argc, const char* const* argv, Options& options);

} // namespace pcl_ops::benchmark
