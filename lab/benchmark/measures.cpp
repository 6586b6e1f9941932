// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "measures.h"

#include <pcl/common/io.h>
#include <pcl/kdtree/kdtree_flann.h>

#include <boost/interprocess/anonymous_shared_memory.hpp>

#include <detection/methods.h>
#include <simulation/simulated_cloud.h>

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include <algorithm>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <thread>

namespace pcl_ops::benchmark {

using namespace evaluation;

namespace {

/** \param[in] names of configurations; a peer detector that exceeds the time limit is
 * stopped and reported */
std::vector<Measure>
detectorsOn (const XyzCloud::ConstPtr& cloud,
             const std::string& names,
             std::size_t runs,
             const RunSettings& settings)
{
  std::vector<Measure> measures;
  for (const Configuration& detector : selectConfigurations (names))
    if (runs > 0 && !detector.needs_image)
      measures.push_back (
          {detector.name, runs, [=] {
             constexpr unsigned time_limit = 600; // [s]
             if (const auto run = runLimited (detector, cloud, settings, time_limit))
               return run->durations;
             std::cerr << detector.name << ": stopped after " << time_limit << " s\n";
             StageDurations durations;
             durations.detection = 1e3 * time_limit;
             return durations;
           }});
  return measures;
}

std::vector<Measure>
presetsOn (const XyzCloud::ConstPtr& cloud,
           const MeasureParameters& parameters,
           unsigned threads = 1,
           std::optional<double> sampling_rate = std::nullopt)
{
  RunSettings settings = parameters.settings;
  settings.threads = threads;
  settings.sampling_rate = sampling_rate;
  auto measures = detectorsOn (cloud, "ops,ops-3-30", parameters.runs, settings);
  measures[1].name = "ops paper";
  return measures;
}

std::vector<Measure>
leastMeasures (const XyzCloud::ConstPtr& cloud, std::size_t runs)
{
  const auto timeOf = [runs] (const char* name, const std::function<void()>& work) {
    return Measure{name, runs, [work] {
                     StageDurations durations;
                     timed (durations.detection, work);
                     return durations;
                   }};
  };
  const auto copy = std::make_shared<XyzCloud> (*cloud);
  return {timeOf ("copy of the cloud",
                  [=] { std::copy (cloud->begin(), cloud->end(), copy->begin()); }),
          timeOf ("KdTreeFLANN construction", [cloud] {
            pcl::KdTreeFLANN<pcl::PointXYZ>().setInputCloud (cloud);
          })};
}

std::vector<Measure>
joined (const std::vector<std::vector<Measure>>& lists)
{
  std::vector<Measure> all;
  for (const std::vector<Measure>& list : lists)
    all.insert (all.end(), list.begin(), list.end());
  return all;
}

std::vector<Measure>
allOn (const XyzCloud::ConstPtr& cloud, const MeasureParameters& parameters)
{
  const auto& [runs, peer_runs, settings] = parameters;
  return joined ({presetsOn (cloud, parameters),
                  detectorsOn (cloud, "kht", runs, settings),
                  leastMeasures (cloud, runs)});
}

/** A number in /proc/self/status [byte]; NaN if there is none. */
double
statusBytes (const std::string& name)
{
  constexpr double bytes_per_kilobyte = 1024.0;
  const std::string kilobytes = valueIn ("/proc/self/status", name);
  return kilobytes.empty() ? std::numeric_limits<double>::quiet_NaN()
                           : bytes_per_kilobyte * std::stod (kilobytes);
}

} // namespace

std::string
valueIn (const std::string& file, const std::string& name)
{
  std::ifstream lines (file);
  for (std::string line; std::getline (lines, line);)
    if (const std::size_t colon = line.find (':'); line.rfind (name, 0) == 0)
      return line.substr (line.find_first_not_of (" \t", colon + 1));
  return "";
}

std::vector<Measure>
measureInTurns (std::vector<Measure> measures, const Notify& notify)
{
  for (bool is_done = false; !is_done;) {
    is_done = true;
    for (Measure& measure : measures) {
      if (measure.runs == measure.max_runs || measure.spent > patience)
        continue;
      is_done = false;
      notify (measure.name);
      const StageDurations durations = measure.run();
      measure.spent += durations.detection;
      if (measure.runs++ == 0 || durations.detection < measure.best.detection)
        measure.best = durations;
    }
  }
  return measures;
}

std::vector<Measure>
measuresOf (const XyzCloud::ConstPtr& cloud, const MeasureParameters& parameters)
{
  const auto& [runs, peer_runs, settings] = parameters;
  Measure on_two_threads = presetsOn (cloud, parameters, 2).front();
  on_two_threads.name = "ops, two threads";
  constexpr const char* ours = "ops,ops-3-30,ops-0.3-10,kht,fspf-0.07-0.14";
  return joined ({leastMeasures (cloud, runs),
                  {on_two_threads},
                  detectorsOn (cloud, ours, runs, settings),
                  detectorsOn (cloud, "peers", peer_runs, settings)});
}

double
peakMemoryOn (const XyzCloud::ConstPtr& cloud, const Configuration& detector)
{
  // A run on a small cloud first makes the pages of the program itself resident.
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
    malloc_trim (0); // reused free memory would not show as growth
#endif
    // "5" resets the peak to the memory that is resident now (proc(5)).
    std::ofstream ("/proc/self/clear_refs") << "5";
    const double before = statusBytes ("VmRSS");
    detector.run (cloud, {});
    growth = statusBytes ("VmHWM") - before;
  };
  try {
    runInChild (measure, 0);
  }
  catch (const std::runtime_error&) { // the number stays NaN
  }
  return growth;
}

simulation::Scene
makeBoards (unsigned number)
{
  using namespace simulation;
  constexpr double spacing = 2.0; // [m]; a board is 1 m wide
  // Its multiples are spread evenly on the circle [rad].
  constexpr double golden_angle = 2.399963229728653;
  constexpr double steepest = 0.5; // [rad]
  const auto columns = unsigned (std::ceil (std::sqrt (double (number))));
  Body board;
  board.addSurface ({});
  Scene scene;
  for (unsigned i = 0; i < number; ++i)
    scene.add (board,
               at ({spacing * (i % columns), spacing * (i / columns), 0}) *
                   turnZ (golden_angle * i) * turnX (steepest * i / number));
  return scene;
}

std::string
measureScaling (const DataSet& clouds,
                const DataSet& growing,
                const MeasureParameters& parameters,
                const Notify& notify)
{
  std::ostringstream csv;
  csv << "series,x,points,measure,runs,cloud";
  for (const auto& stage : apps::detection_stages)
    csv << ',' << stage.first << "_ms";
  csv << '\n';
  std::string name = clouds.front().name;
  const auto add = [&] (const char* series,
                        double x,
                        const XyzCloud::ConstPtr& cloud,
                        const std::vector<Measure>& measures) {
    for (const Measure& measure : measureInTurns (measures, notify)) {
      csv << series << ',' << x << ',' << cloud->size() << ',' << measure.name << ','
          << measure.runs << ',' << std::quoted (name, '"', '"');
      for (const auto& stage : apps::detection_stages)
        csv << ',' << measure.best.*stage.second;
      csv << '\n';
    }
  };
  const XyzCloud::ConstPtr cloud = clouds.front().load().cloud;
  const unsigned most = std::max (2u, std::thread::hardware_concurrency());
  for (const CloudSource& source : clouds) {
    name = source.name;
    const XyzCloud::ConstPtr kind = source.load().cloud;
    add ("threads", 1, kind, allOn (kind, parameters));
    for (unsigned threads = 2; threads <= most; ++threads)
      add ("threads", threads, kind, presetsOn (kind, parameters, threads));
  }
  for (const double rate : {0.003, 0.005, 0.01, 0.03, 0.05, 0.1})
    add ("sampling_rate", 100.0 * rate, cloud, presetsOn (cloud, parameters, 1, rate));
  for (const unsigned planes : {1u, 3u, 10u, 30u, 100u, 300u}) {
    const auto scan = simulation::scanDensely (
        makeBoards (planes), cloud->size(), 1.0, parameters.settings.seed);
    const XyzCloud::Ptr boards (new XyzCloud);
    pcl::copyPointCloud (scan.cloud, *boards);
    add ("planes", planes, boards, allOn (boards, parameters));
  }
  for (const CloudSource& source : growing) {
    name = source.name;
    notify ("simulating " + name);
    const XyzCloud::ConstPtr scan = source.load().cloud;
    add ("points", double (scan->size()), scan, allOn (scan, parameters));
  }
  return csv.str();
}

} // namespace pcl_ops::benchmark
