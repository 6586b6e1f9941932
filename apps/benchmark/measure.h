// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <evaluation/detectors/detector_run.h>

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
  /** \brief About how long a run takes [ms], where that may be long. */
  double expected = 0.0;
};

/** \brief The run of a measure with the shortest whole. */
struct BestTime {
  std::string name;
  StageDurations durations;
  std::size_t runs = 0;
};

using BestTimes = std::vector<BestTime>;

/** \brief Is told what is being done, and about how long it takes [ms]; 0: not
 * long. */
using Notify = std::function<void (const std::string& what, double expected)>;

/** \brief Is told the best time of a measure that will not be run again. */
using Finish = std::function<void (const BestTime& time)>;

/** \brief Runs each measure once, then each a second time, and so on, so that a slow
 * phase of the machine hits all alike. What has taken \ref patience is not repeated.
 * \return the best of each in the order given */
BestTimes
measureInTurns (const std::vector<Measure>& measures,
                const Notify& notify,
                const Finish& finish);

/** \brief [ms] */
constexpr double patience = 20000.0;

/** \brief The whole of a measure [ms]; NaN for a name nothing has. */
double
bestOf (const BestTimes& times, const std::string& name);

/** \brief A detector of this project with all its parameters, threads too. */
template <typename Detector>
Measure
detectorMeasure (const std::string& name,
                 std::size_t runs,
                 const typename Detector::Parameters& parameters,
                 const evaluation::XyzCloud::ConstPtr& cloud)
{
  return {name, runs, [parameters, cloud] {
            return evaluation::runDetector<Detector> (parameters, cloud).durations;
          }};
}

} // namespace pcl_ops::benchmark
