// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "detectors.h"

#include <ctime>

namespace pcl_ops::evaluation {

/** \brief What a clock shows [ms]. */
inline double
now (Clock clock)
{
  timespec time{};
  clock_gettime (clock == Clock::Wall ? CLOCK_MONOTONIC : CLOCK_THREAD_CPUTIME_ID,
                 &time);
  return 1e3 * double (time.tv_sec) + 1e-6 * double (time.tv_nsec);
}

/** \brief Runs something and adds its time to a duration [ms]. */
template <typename Work>
auto
timed (double& duration, Clock clock, Work&& work)
{
  struct Watch {
    double& duration;
    Clock clock;
    double start;
    ~Watch() { duration += now (clock) - start; }
  } const watch{duration, clock, now (clock)};
  return work();
}

/** \brief Runs a detector of this project.
 * \param[in] parameters all of them: up axis, seed and threads too
 * \param[in] cloud finite points
 * \param[in] clock of the whole; that of the stages is the wall's */
template <typename Detector>
DetectorRun
runDetector (const typename Detector::Parameters& parameters,
             const XyzCloud::ConstPtr& cloud,
             Clock clock = Clock::Wall)
{
  DetectorRun result;
  double detection = 0.0;
  timed (detection, clock, [&] {
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

/** \brief Does something in a process of its own, whose memory but for what is shared
 * goes with it.
 * \param[in] seconds of wall time, after which it is ended; 0: none
 * \return whether it was done before that
 * \throw std::runtime_error if it fails, however it does */
bool
runInChild (const std::function<void()>& work, unsigned seconds);

/** \brief Runs a detector, one of others in a process of its own.
 * \param[in] seconds, and errors, as of \ref runInChild
 * \return nothing if it takes longer */
std::optional<DetectorRun>
runLimited (const Configuration& configuration,
            const XyzCloud::ConstPtr& cloud,
            const RunSettings& settings,
            unsigned seconds);

} // namespace pcl_ops::evaluation
