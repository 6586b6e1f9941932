// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "measures.h"

#include <pcl/kdtree/kdtree_flann.h>

#include <boost/interprocess/anonymous_shared_memory.hpp>

#include <pcl_ops/oriented_point_sampling.h>

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include <algorithm>
#include <fstream>
#include <iostream>
#include <limits>
#include <memory>
#include <stdexcept>

namespace pcl_ops::benchmark {

namespace {

/** \brief A measure without stages. */
Measure
measureOf (const std::string& name, std::size_t runs, const std::function<void()>& work)
{
  return {name, runs, [work] {
            StageDurations durations;
            evaluation::timed (durations.detection, evaluation::Clock::Processor, work);
            return durations;
          }};
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
  if (const auto run = evaluation::runLimited (detector, cloud, settings, time_limit))
    return run->durations;
  std::cerr << detector.name << ": stopped after " << time_limit << " s\n";
  StageDurations durations;
  durations.detection = 1e3 * time_limit;
  return durations;
}

/** A line of /proc/self/status [byte]; NaN if there is none. */
double
statusBytes (const std::string& name)
{
  constexpr double bytes_per_kilobyte = 1024.0;
  std::ifstream status ("/proc/self/status");
  for (std::string line; std::getline (status, line);)
    if (line.rfind (name + ":", 0) == 0)
      return bytes_per_kilobyte * std::stod (line.substr (name.size() + 1));
  return std::numeric_limits<double>::quiet_NaN();
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

std::vector<Measure>
leastMeasures (const XyzCloud::ConstPtr& cloud, std::size_t runs)
{
  const auto copy = std::make_shared<XyzCloud> (*cloud);
  return {measureOf ("copy of the cloud",
                     runs,
                     [cloud, copy] {
                       std::copy (cloud->begin(), cloud->end(), copy->begin());
                     }),
          measureOf ("KdTreeFLANN construction", runs, [cloud] {
            pcl::KdTreeFLANN<pcl::PointXYZ>().setInputCloud (cloud);
          })};
}

std::vector<Measure>
measuresOf (const XyzCloud::ConstPtr& cloud, const MeasureParameters& parameters)
{
  using Ops = OrientedPointSampling<pcl::PointXYZ>;
  std::vector<Measure> measures = leastMeasures (cloud, parameters.runs);
  Ops::Parameters two_threads;
  two_threads.seed = parameters.seed;
  two_threads.threads = 2;
  measures.push_back (
      detectorMeasure<Ops> ("ops, two threads", parameters.runs, two_threads, cloud));
  for (const auto& [names, runs] :
       {std::pair ("ops,ops-3-30,ops-0.3-10,kht,fspf-0.07-0.14", parameters.runs),
        {"peers", parameters.peer_runs}})
    for (const auto& detector : evaluation::selectConfigurations (names))
      if (runs > 0 && !detector.needs_image)
        measures.push_back (
            {detector.name, runs, [detector, cloud, seed = parameters.seed] {
               return durationsOf (detector, cloud, seed);
             }});
  return measures;
}

double
peakMemoryOn (const XyzCloud::ConstPtr& cloud,
              const evaluation::Configuration& detector)
{
  // The pages of the program itself are resident once a small cloud has used them.
  constexpr std::size_t small = 5000;
  const XyzCloud::Ptr few (new XyzCloud);
  const std::size_t stride = std::max<std::size_t> (1, cloud->size() / small);
  for (std::size_t i = 0; i < cloud->size(); i += stride)
    few->push_back ((*cloud)[i]);
  const auto memory = boost::interprocess::anonymous_shared_memory (sizeof (double));
  double& growth = *static_cast<double*> (memory.get_address());
  growth = std::numeric_limits<double>::quiet_NaN();
  const auto measure = [&] {
    detector.run (few, {});
#ifdef __GLIBC__
    malloc_trim (0); // freed memory that is kept would hide what is allocated next
#endif
    // "5" sets the peak back to what is resident now (proc(5)).
    std::ofstream ("/proc/self/clear_refs") << "5";
    const double before = statusBytes ("VmRSS");
    detector.run (cloud, {});
    growth = statusBytes ("VmHWM") - before;
  };
  try {
    evaluation::runInChild (measure, 0);
  }
  catch (const std::runtime_error&) { // the number stays NaN
  }
  return growth;
}

} // namespace pcl_ops::benchmark
