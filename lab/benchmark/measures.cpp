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

/** Returns a measure for each configuration that needs no image. A peer detector that
 * exceeds the time limit is stopped, which is reported, and has the limit as its time.
 * \param[in] names of configurations and groups, separated by commas
 * \param[in] runs 0: no measures */
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
             constexpr unsigned time_limit = 600; // as EvaluationPlan has [s]
             if (const auto run = runLimited (detector, cloud, settings, time_limit))
               return run->durations;
             std::cerr << detector.name << ": stopped after " << time_limit << " s\n";
             StageDurations durations;
             durations.detection = 1e3 * time_limit;
             return durations;
           }});
  return measures;
}

/** Returns measures of the default and of the paper's preset of OPS, in this order. */
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
  // Measures come in the order of the names, as MeasureParameters::runs is above 0.
  measures[1].name = "ops paper";
  return measures;
}

/** Returns measures of what nearly every detector does at least: a copy of the cloud
 * into allocated memory, and the construction of a search tree. */
std::vector<Measure>
lowerBoundsOn (const XyzCloud::ConstPtr& cloud, std::size_t runs)
{
  const auto measureOf = [runs] (const char* name, const std::function<void()>& work) {
    return Measure{name, runs, [work] {
                     StageDurations durations;
                     timed (durations.detection, work);
                     return durations;
                   }};
  };
  const auto copy = std::make_shared<XyzCloud> (*cloud);
  return {measureOf ("copy of the cloud",
                     [=] { std::copy (cloud->begin(), cloud->end(), copy->begin()); }),
          measureOf ("KdTreeFLANN construction", [cloud] {
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

/** Returns the measures on one thread of \ref measureScaling. */
std::vector<Measure>
scalingMeasuresOn (const XyzCloud::ConstPtr& cloud, const MeasureParameters& parameters)
{
  return joined ({presetsOn (cloud, parameters),
                  detectorsOn (cloud, "kht", parameters.runs, parameters.settings),
                  lowerBoundsOn (cloud, parameters.runs)});
}

/** The CSV of \ref measureScaling. */
class ScalingTable {
public:
  explicit ScalingTable (const Notify& notify) : notify_ (notify)
  {
    csv_ << "series,x,points,measure,runs,cloud";
    for (const auto& [stage, duration] : apps::detection_stages)
      csv_ << ',' << stage << "_ms";
    csv_ << '\n';
  }

  /** Runs measures of a cloud and adds a row for each.
   * \param[in] x value of the quantity that grows in the series
   * \param[in] cloud_name for the column cloud */
  void
  add (const char* series,
       double x,
       const std::string& cloud_name,
       const XyzCloud::ConstPtr& cloud,
       const std::vector<Measure>& measures)
  {
    for (const Measure& measure : measureInTurns (measures, notify_)) {
      csv_ << series << ',' << x << ',' << cloud->size() << ',' << measure.name << ','
           << measure.runs << ',' << std::quoted (cloud_name, '"', '"');
      for (const auto& [stage, duration] : apps::detection_stages)
        csv_ << ',' << measure.shortest.*duration;
      csv_ << '\n';
    }
  }

  std::string
  text () const
  {
    return csv_.str();
  }

private:
  const Notify& notify_;
  std::ostringstream csv_;
};

/** Adds the series threads: each cloud on one thread up to all processors, at least
 * two.
 */
void
addThreadsSeries (const DataSet& clouds,
                  const MeasureParameters& parameters,
                  ScalingTable& table)
{
  constexpr const char* series = "threads";
  const unsigned most_threads = std::max (2u, std::thread::hardware_concurrency());
  for (const CloudSource& source : clouds) {
    const XyzCloud::ConstPtr cloud = source.load().cloud;
    table.add (series, 1, source.name, cloud, scalingMeasuresOn (cloud, parameters));
    for (unsigned threads = 2; threads <= most_threads; ++threads)
      table.add (
          series, threads, source.name, cloud, presetsOn (cloud, parameters, threads));
  }
}

/** Returns a scan of \ref makeBoards.
 * \param[in] board_count number of boards
 * \param[in] points number of points of the scan */
XyzCloud::ConstPtr
scanOfBoards (unsigned board_count, std::size_t points, simulation::Seed seed)
{
  constexpr double noise_factor = 1.0; // that of a laser scanner
  const simulation::SimulatedCloud scan =
      simulation::scanDensely (makeBoards (board_count), points, noise_factor, seed);
  const XyzCloud::Ptr boards (new XyzCloud);
  pcl::copyPointCloud (scan.cloud, *boards);
  return boards;
}

/** Returns a number of /proc/self/status [byte]; NaN if there is none of this name. */
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
  for (bool is_complete = false; !is_complete;) {
    is_complete = true;
    for (Measure& measure : measures) {
      if (measure.runs == measure.max_runs || measure.total_time > max_repeated_time)
        continue;
      is_complete = false;
      notify (measure.name);
      const StageDurations durations = measure.run();
      measure.total_time += durations.detection;
      const bool is_first = measure.runs == 0;
      if (is_first || durations.detection < measure.shortest.detection)
        measure.shortest = durations;
      ++measure.runs;
    }
  }
  return measures;
}

std::vector<Measure>
measuresOf (const XyzCloud::ConstPtr& cloud, const MeasureParameters& parameters)
{
  Measure on_two_threads = presetsOn (cloud, parameters, 2).front();
  on_two_threads.name = "ops, two threads";
  constexpr const char* ours = "ops,ops-3-30,ops-0.3-10,kht,fspf-0.07-0.14";
  const RunSettings& settings = parameters.settings;
  return joined ({lowerBoundsOn (cloud, parameters.runs),
                  {on_two_threads},
                  detectorsOn (cloud, ours, parameters.runs, settings),
                  detectorsOn (cloud, "peers", parameters.peer_runs, settings)});
}

double
peakMemoryOn (const XyzCloud::ConstPtr& cloud, const Configuration& detector)
{
  // A run on a small cloud first makes the pages of the program itself resident.
  constexpr std::size_t points_of_small_cloud = 5000;
  const XyzCloud::Ptr small_cloud (new XyzCloud);
  const std::size_t stride =
      std::max<std::size_t> (1, cloud->size() / points_of_small_cloud);
  for (std::size_t i = 0; i < cloud->size(); i += stride)
    small_cloud->push_back ((*cloud)[i]);
  const auto memory = boost::interprocess::anonymous_shared_memory (sizeof (double));
  double& growth = *static_cast<double*> (memory.get_address());
  growth = std::numeric_limits<double>::quiet_NaN();
  const auto measure = [&] {
    detector.run (small_cloud, {});
#ifdef __GLIBC__
    // Gives free memory back to the system: if it were used again, it would not count
    // as growth.
    malloc_trim (0);
#endif
    // "5" resets the peak to the memory that is resident now (proc(5)).
    std::ofstream ("/proc/self/clear_refs") << "5";
    const double before = statusBytes ("VmRSS");
    detector.run (cloud, {});
    growth = statusBytes ("VmHWM") - before;
  };
  constexpr unsigned no_time_limit = 0;
  try {
    runInChild (measure, no_time_limit);
  }
  catch (const std::runtime_error&) { // growth stays NaN
  }
  return growth;
}

simulation::Scene
makeBoards (unsigned number)
{
  using namespace simulation;
  constexpr double spacing = 2.0; // [m]; a board is 1 m wide
  // Multiples of the golden angle are spread evenly on the circle [rad].
  constexpr double golden_angle = 2.399963229728653;
  constexpr double largest_tilt = 0.5; // [rad]
  const auto columns = unsigned (std::ceil (std::sqrt (double (number))));
  Body board;
  board.addSurface ({});
  Scene scene;
  for (unsigned i = 0; i < number; ++i)
    scene.add (board,
               at ({spacing * (i % columns), spacing * (i / columns), 0}) *
                   turnZ (golden_angle * i) * turnX (largest_tilt * i / number));
  return scene;
}

std::string
measureScaling (const DataSet& clouds,
                const DataSet& clouds_by_size,
                const MeasureParameters& parameters,
                const Notify& notify)
{
  ScalingTable table (notify);
  const CloudSource& first = clouds.front();
  const XyzCloud::ConstPtr first_cloud = first.load().cloud;
  addThreadsSeries (clouds, parameters, table);
  for (const double rate : {0.003, 0.005, 0.01, 0.03, 0.05, 0.1})
    table.add ("sampling_rate",
               100.0 * rate,
               first.name,
               first_cloud,
               presetsOn (first_cloud, parameters, 1, rate));
  for (const unsigned planes : {1u, 3u, 10u, 30u, 100u, 300u}) {
    const XyzCloud::ConstPtr boards =
        scanOfBoards (planes, first_cloud->size(), parameters.settings.seed);
    table.add (
        "planes", planes, "boards", boards, scalingMeasuresOn (boards, parameters));
  }
  for (const CloudSource& source : clouds_by_size) {
    notify ("simulating " + source.name);
    const XyzCloud::ConstPtr scan = source.load().cloud;
    table.add ("points",
               double (scan->size()),
               source.name,
               scan,
               scalingMeasuresOn (scan, parameters));
  }
  return table.text();
}

} // namespace pcl_ops::benchmark
