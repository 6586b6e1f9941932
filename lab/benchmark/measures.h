// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <evaluation/detectors/detectors.h>
#include <simulation/scene.h>

namespace pcl_ops::benchmark {

using evaluation::Configuration;
using evaluation::DataSet;
using evaluation::XyzCloud;

/** Returns the text behind the colon of the first line of a /proc file that begins with
 * a name; empty if there is no such line. */
std::string
valueIn (const std::string& file, const std::string& name);

/** Something whose time is measured, and the result of its runs so far. */
struct Measure {
  std::string name;
  std::size_t max_runs = 1;
  std::function<StageDurations()> run; // runs once and returns its durations [ms]
  std::size_t runs = 0;                // number of runs so far
  double total_time = 0.0;             // of all runs [ms]
  StageDurations shortest = {};        // of the run whose detection is shortest [ms]
};

/** Called before each run with the name of the measure, to show it to the user. */
using Notify = std::function<void (const std::string& what)>;

/** Runs each measure once, then each a second time, and so on, so that a slow phase of
 * the machine affects all measures. A measure that has taken more than
 * \ref max_repeated_time in total is not repeated. */
std::vector<Measure>
measureInTurns (std::vector<Measure> measures, const Notify& notify);

/** Total time of a measure beyond which it is not repeated [ms]. */
constexpr double max_repeated_time = 20000.0;

struct MeasureParameters {
  std::size_t runs = 5;                  // of each measure but those of peer detectors
  std::size_t peer_runs = 1;             // of peer detectors; 0: peers are left out
  evaluation::RunSettings settings = {}; // of all detectors
};

/** Returns measures that have not run yet: for comparison, a copy of the cloud into
 * allocated memory and the construction of pcl::KdTreeFLANN; the default preset on two
 * threads; configurations of OPS, 3D-KHT and FSPF on one thread; the peer detectors. */
std::vector<Measure>
measuresOf (const XyzCloud::ConstPtr& cloud, const MeasureParameters& parameters);

/** Returns by how much the peak resident memory of a child process grows during a
 * detection on one thread, the labels of all points included [byte]. NaN if /proc does
 * not give it or the detection fails. */
double
peakMemoryOn (const XyzCloud::ConstPtr& cloud, const Configuration& detector);

/** Makes square boards, each in another orientation and far enough apart that no two
 * are found as one plane.
 * \param[in] number of boards */
simulation::Scene
makeBoards (unsigned number);

/** Returns a CSV of the times of OPS (default and paper preset) in four series: points,
 * threads, sampling_rate [%] and planes. In each series the quantity that names it
 * grows; its values are in the column x. On one thread, all series but sampling_rate
 * also have 3D-KHT, the copy and the kd-tree of \ref measuresOf.
 * \param[in] clouds for the series threads; the first one also for sampling_rate, and
 * its number of points for the simulated boards of the series planes
 * \param[in] clouds_by_size for the series points, by ascending number of points */
std::string
measureScaling (const DataSet& clouds,
                const DataSet& clouds_by_size,
                const MeasureParameters& parameters,
                const Notify& notify);

} // namespace pcl_ops::benchmark
