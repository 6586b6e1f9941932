// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "measures.h"

#include <pcl/kdtree/kdtree_flann.h>

#include <evaluation/detectors/limited_run.h>
#include <pcl_ops/oriented_point_sampling.h>

#include <algorithm>
#include <iostream>
#include <memory>

namespace pcl_ops::benchmark {

namespace {

using evaluation::timed;

/** \brief A measure without stages. */
Measure
measureOf (const std::string& name, std::size_t runs, const std::function<void()>& work)
{
  return {name, runs, [work] {
            StageDurations durations;
            timed (durations.detection, evaluation::Clock::Processor, work);
            return durations;
          }};
}

Measure
twoThreadsMeasure (const XyzCloud::ConstPtr& cloud, const MeasureParameters& parameters)
{
  OrientedPointSamplingParameters ops;
  ops.seed = parameters.seed;
  ops.threads = 2;
  return detectorMeasure<OrientedPointSampling<pcl::PointXYZ>> (
      "ops, two threads", parameters.runs, ops, cloud);
}

/** \brief A detector of others may take any time: then it is said and ended. */
StageDurations
durationsOf (const evaluation::Configuration& detector,
             const XyzCloud::ConstPtr& cloud,
             std::uint32_t seed)
{
  constexpr unsigned time_limit = 600; // [s]
  evaluation::RunSettings settings;
  settings.seed = seed;
  settings.clock = evaluation::Clock::Processor;
  if (!detector.is_peer)
    return detector.run (cloud, settings).durations;
  if (const auto run = evaluation::runLimited (detector, cloud, settings, time_limit))
    return run->durations;
  std::cerr << detector.name << ": stopped after " << time_limit << " s\n";
  StageDurations durations;
  durations.detection = 1e3 * time_limit;
  return durations;
}

void
addDetectors (const std::string& names,
              std::size_t runs,
              const XyzCloud::ConstPtr& cloud,
              std::uint32_t seed,
              std::vector<Measure>& measures)
{
  for (const evaluation::Configuration& detector :
       evaluation::selectConfigurations (names))
    if (!detector.needs_grid)
      measures.push_back ({detector.name, runs, [detector, cloud, seed] {
                             return durationsOf (detector, cloud, seed);
                           }});
}

} // namespace

std::vector<BestTime>
measureInTurns (const std::vector<Measure>& measures, const Notify& notify)
{
  std::vector<BestTime> best (measures.size());
  std::vector<double> spent (measures.size(), 0.0);
  bool is_done = false;
  for (std::size_t turn = 0; !is_done; ++turn) {
    is_done = true;
    for (std::size_t i = 0; i < measures.size(); ++i) {
      if (turn >= measures[i].runs || spent[i] > patience)
        continue;
      is_done = false;
      notify (measures[i].name);
      const StageDurations durations = measures[i].run();
      spent[i] += durations.detection;
      if (turn == 0 || durations.detection < best[i].durations.detection)
        best[i] = {measures[i].name, durations, 0};
      best[i].runs = turn + 1;
    }
  }
  return best;
}

Measure
copyMeasure (const XyzCloud::ConstPtr& cloud, std::size_t runs)
{
  return measureOf (
      "copy of the cloud", runs, [cloud, copy = std::make_shared<XyzCloud> (*cloud)] {
        std::copy (cloud->begin(), cloud->end(), copy->begin());
      });
}

Measure
kdTreeMeasure (const XyzCloud::ConstPtr& cloud, std::size_t runs)
{
  return measureOf ("KdTreeFLANN construction", runs, [cloud] {
    pcl::KdTreeFLANN<pcl::PointXYZ>().setInputCloud (cloud);
  });
}

std::vector<Measure>
measuresOf (const XyzCloud::ConstPtr& cloud, const MeasureParameters& parameters)
{
  std::vector<Measure> measures{copyMeasure (cloud, parameters.runs),
                                kdTreeMeasure (cloud, parameters.runs),
                                twoThreadsMeasure (cloud, parameters)};
  addDetectors (std::string (default_preset) +
                    ",ops-3-30,ops-0.3-10,kht,fspf-0.07-0.14",
                parameters.runs,
                cloud,
                parameters.seed,
                measures);
  if (parameters.peer_runs > 0)
    addDetectors ("peers", parameters.peer_runs, cloud, parameters.seed, measures);
  return measures;
}

} // namespace pcl_ops::benchmark
