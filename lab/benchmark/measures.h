// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <evaluation/detectors/detectors.h>
#include <simulation/scene.h>

namespace pcl_ops::benchmark {

using evaluation::Configuration;
using evaluation::DataSet;
using evaluation::XyzCloud;

/** What is behind the colon of the line of that name of a file in /proc, if any. */
std::string
valueIn (const std::string& file, const std::string& name);

struct Measure {
  std::string name;
  std::size_t max_runs = 1;
  std::function<StageDurations()> run; // [ms]
  /** How often it has run, how long that took, and the run with the shortest whole. */
  std::size_t runs = 0;
  double spent = 0.0;
  StageDurations best = {};
};

using Notify = std::function<void (const std::string& what)>;

/** Runs each measure once, then each a second time, and so on, so that a slow phase of
 * the machine hits all alike. What has taken \ref patience is not repeated. */
std::vector<Measure>
measureInTurns (std::vector<Measure> measures, const Notify& notify);

/** [ms] */
constexpr double patience = 20000.0;

struct MeasureParameters {
  std::size_t runs = 5;
  std::size_t peer_runs = 1; // of detectors of others; 0: they are left out
  evaluation::RunSettings settings = {};
};

/** Copying the cloud onto memory that is there already and building pcl::KdTreeFLANN,
 * which no method is faster than; the default preset on two threads, the presets, and
 * the detectors of others. */
std::vector<Measure>
measuresOf (const XyzCloud::ConstPtr& cloud, const MeasureParameters& parameters);

/** By how much a detection on one thread lets the resident memory of a child process
 * grow at its peak, labels of all points included [byte]. NaN where the system does not
 * tell. */
double
peakMemoryOn (const XyzCloud::ConstPtr& cloud, const Configuration& detector);

/** Square boards, each turned another way, too far apart for two to be taken for
 * one. */
simulation::Scene
makeBoards (unsigned number);

/** CSV of times of OPS, default and paper preset, where one thing grows at a time:
 * points, threads, sampling_rate (in per cent) or planes; but for the sampling rate
 * also of 3D-KHT and what no method is faster than.
 * \param[in] clouds for threads; the first for the sampling rate, and with its number
 * of points for the simulated boards of the planes */
std::string
measureScaling (const DataSet& clouds,
                const DataSet& growing,
                const MeasureParameters& parameters,
                const Notify& notify);

} // namespace pcl_ops::benchmark
