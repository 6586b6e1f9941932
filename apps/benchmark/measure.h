// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/plane_detector.h>

#include <functional>
#include <string>
#include <vector>

namespace pcl_ops::benchmark {

/** \brief Something to be timed. */
struct Measure {
  std::string name;
  /** \brief How often at most. */
  std::size_t runs = 1;
  /** \brief Its times [ms]: of the stages where it has stages, and of the whole. */
  std::function<StageDurations()> run;
};

/** \brief The run of a measure with the shortest whole. */
struct BestTime {
  std::string name;
  StageDurations durations;
  std::size_t runs = 0;
};

using BestTimes = std::vector<BestTime>;

/** \brief Is told what is being done. */
using Notify = std::function<void (const std::string& what)>;

/** \brief Runs each measure once, then each a second time, and so on, so that a slow
 * phase of the machine hits all alike. What has taken \ref patience is not repeated.
 * \return the best of each in the order given */
BestTimes
measureInTurns (const std::vector<Measure>& measures, const Notify& notify);

/** \brief [ms] */
constexpr double patience = 20000.0;

/** \brief The whole of a measure [ms]; NaN for a name nothing has. */
double
bestOf (const BestTimes& times, const std::string& name);

} // namespace pcl_ops::benchmark
