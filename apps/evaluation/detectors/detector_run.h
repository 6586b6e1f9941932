// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/common/time.h>

#include "detectors.h"

namespace pcl_ops::evaluation {

/** \brief Runs something and adds its wall time to a duration [ms]. */
template <typename Work>
auto
timed (double& duration, Work&& work)
{
  struct Watch {
    double& duration;
    pcl::StopWatch watch;
    ~Watch() { duration += watch.getTime(); }
  } const watch{duration, {}};
  return work();
}

/** \brief Runs a detector of this project.
 * \param[in] parameters all of them: up axis, seed and threads too
 * \param[in] cloud finite points */
template <typename Detector>
DetectorRun
runDetector (const typename Detector::Parameters& parameters,
             const XyzCloud::ConstPtr& cloud)
{
  DetectorRun result;
  double detection = 0.0;
  timed (detection, [&] {
    Detector detector;
    detector.setParameters (parameters);
    detector.setInputCloud (cloud);
    std::vector<pcl::PointIndices> planes;
    detector.extract (planes);
    result.labels = labelsOf (planes, cloud->size());
    result.durations = detector.getStageDurations();
    result.planes_before_merging = detector.getNumberOfPlanesBeforeMerging();
  });
  result.durations.detection = detection;
  return result;
}

/** \brief A detector of this project as a configuration. */
template <typename Detector>
Configuration
configurationOf (const std::string& name,
                 const std::vector<std::string>& groups,
                 const typename Detector::Parameters& parameters)
{
  const auto run = [parameters] (const XyzCloud::ConstPtr& cloud,
                                 const RunSettings& settings) {
    auto complete = parameters;
    complete.up_axis = settings.up.cast<float>();
    complete.seed = settings.seed;
    complete.threads = 1;
    return runDetector<Detector> (complete, cloud);
  };
  return {name, groups, run};
}

} // namespace pcl_ops::evaluation
