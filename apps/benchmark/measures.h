// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <evaluation/detectors/detectors.h>
#include <simulation/scene.h>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace pcl_ops::benchmark {

using evaluation::XyzCloud;

/** \brief What is behind the colon of the line of that name of a file in /proc; empty
 * if there is none. */
std::string
valueIn (const std::string& file, const std::string& name);

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

/** \brief What no method is faster than (a copy of the cloud onto memory that is there
 * already, and building pcl::KdTreeFLANN), the default preset on two threads, the
 * presets, and the detectors of others.
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

/** \brief A scene with a known number of planes: square boards, each turned another
 * way, too far apart for two to be taken for one. */
simulation::Scene
makeBoards (unsigned number);

/** \brief Times of OPS, default and paper preset, where one thing grows at a time:
 * points, threads, sampling_rate (in per cent) or planes; but for the sampling rate
 * also of 3D-KHT and what no method is faster than.
 * \param[in] clouds for threads; the first for the sampling rate, and with its number
 * of points for the simulated boards of the planes
 * \param[in] growing clouds of growing size
 * \return CSV */
std::string
measureScaling (const evaluation::DataSet& clouds,
                const evaluation::DataSet& growing,
                const MeasureParameters& parameters,
                const Notify& notify);

} // namespace pcl_ops::benchmark
