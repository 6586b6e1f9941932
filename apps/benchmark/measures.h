// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <evaluation/detectors/detectors.h>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace pcl_ops::benchmark {

using evaluation::XyzCloud;

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

/** \brief Is told what is being done. */
using Notify = std::function<void (const std::string& what)>;

/** \brief Runs each measure once, then each a second time, and so on, so that a slow
 * phase of the machine hits all alike. What has taken \ref patience is not repeated.
 * \return the best of each in the order given */
std::vector<BestTime>
measureInTurns (const std::vector<Measure>& measures, const Notify& notify);

/** \brief [ms] */
constexpr double patience = 20000.0;

/** \brief How often things are measured. */
struct MeasureParameters {
  std::size_t runs = 5;
  /** \brief Of the foreign detectors; 0: they are left out. */
  std::size_t peer_runs = 1;
  std::uint32_t seed = 42;
};

/** \brief A detector of this project with all its parameters, threads too: of one
 * thread processor time, which other programs disturb less, of more wall time. */
template <typename Detector>
Measure
detectorMeasure (const std::string& name,
                 std::size_t runs,
                 const typename Detector::Parameters& parameters,
                 const XyzCloud::ConstPtr& cloud)
{
  return {
      name, runs, [parameters, cloud] {
        using evaluation::Clock;
        const Clock clock = parameters.threads == 1 ? Clock::Processor : Clock::Wall;
        return evaluation::runDetector<Detector> (parameters, cloud, clock).durations;
      }};
}

/** \brief What no method is faster than: a copy of the cloud onto memory that is there
 * already, and building pcl::KdTreeFLANN. */
std::vector<Measure>
leastMeasures (const XyzCloud::ConstPtr& cloud, std::size_t runs);

/** \brief \ref leastMeasures, the default preset on two threads, the presets, and the
 * detectors of others.
 * \param[in] cloud finite points */
std::vector<Measure>
measuresOf (const XyzCloud::ConstPtr& cloud, const MeasureParameters& parameters);

/** \brief What a detection on one thread needs on top of the cloud at its peak [byte],
 * labels of all points included: by how much the resident memory of a child process
 * grows. NaN where the system does not tell.
 * \param[in] cloud finite points */
double
peakMemoryOn (const XyzCloud::ConstPtr& cloud,
              const evaluation::Configuration& detector);

} // namespace pcl_ops::benchmark
