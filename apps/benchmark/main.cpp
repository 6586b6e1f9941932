// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "json_report.h"
#include "options.h"
#include "scaling_report.h"
#include "time_table.h"
#include "worst_cases.h"
#include <cli/errors.h>
#include <cli/memory.h>
#include <cli/program.h>
#include <cli/progress.h>
#include <evaluation/commands/data_options.h>
#include <evaluation/data/data_sets.h>
#include <io/output_file.h>
#include <unistd.h>

#include <iostream>
#include <map>

namespace {

using namespace pcl_ops;
using namespace pcl_ops::benchmark;
using evaluation::DataSet;

/** Says on a terminal what is being done, and anywhere what takes minutes. */
void
notify (const std::string& what, double expected = 0.0)
{
  constexpr const char* erase_line = "\r\033[K";
  constexpr double minute = 60'000.0;
  const bool is_terminal = isatty (STDERR_FILENO) == 1;
  if (is_terminal)
    std::cerr << erase_line << what << std::flush;
  if (expected >= minute)
    std::cerr << (is_terminal ? "" : what) << " takes about "
              << apps::durationText (1e-3 * expected) << std::endl;
}

CloudFigures
figuresOf (const evaluation::CloudSource& source, const MeasureParameters& parameters)
{
  notify ("loading " + source.name);
  const evaluation::XyzCloud::ConstPtr cloud = source.load().cloud;
  const std::vector<Measure> measures = measuresOf (cloud, parameters);
  TimeTable table (std::cout, source.name, cloud->size(), measures);
  const BestTimes times = measureInTurns (
      measures,
      [&] (const std::string& what, double expected) {
        notify (source.name + ": " + what, expected);
      },
      [&] (const BestTime& time) {
        notify ("");
        table.add (time);
      });
  table.end();
  return {source.name, cloud->size(), times, peakMemoryOn (cloud)};
}

/** The default preset's times by the number of points. */
using TimesBySize = std::map<std::size_t, double>;

double
growthIn (const TimesBySize& times)
{
  const auto few = times.find (few_points), many = times.find (many_points);
  if (few == times.end() || many == times.end())
    return std::numeric_limits<double>::quiet_NaN();
  return (many->second / many_points) / (few->second / few_points);
}

TimesBySize
scale (const Options& options, const DataSet& clouds, const DataSet& growing)
{
  const std::vector<ScalingRow> rows = measureScaling (
      clouds.clouds.front().load().cloud, growing.clouds, options.measures, notify);
  if (!writeScaling (rows, options.scaling_folder))
    std::cerr << program_name << ": " << options.scaling_folder
              << ": no plots were drawn; install gnuplot and run it on the .gp files\n";
  TimesBySize times;
  for (const ScalingRow& row : rows)
    if (row.series == over_points && row.time.name == default_preset)
      times[row.points] = row.time.durations.detection;
  return times;
}

/** \param[out] left_out how many of several clouds could not be read */
std::vector<CloudFigures>
figuresOfAll (const DataSet& clouds,
              const MeasureParameters& parameters,
              std::size_t& left_out)
{
  std::vector<CloudFigures> all;
  for (const evaluation::CloudSource& source : clouds.clouds)
    try {
      all.push_back (apps::inMemory (source.name, "give a smaller cloud", [&] {
        return figuresOf (source, parameters);
      }));
    }
    catch (const apps::WorkError& error) {
      if (++left_out == clouds.clouds.size())
        throw;
      notify ("");
      std::cerr << program_name << ": left out: " << error.what() << '\n';
    }
  return all;
}

PeakMemory
peakMemoryOnScan (const std::string& scan)
{
  notify ("memory");
  return peakMemoryOn (evaluation::dataSetOf (scan, Eigen::Vector3d::UnitZ())
                           .clouds.front()
                           .load()
                           .cloud);
}

Benchmark
measure (const Options& options,
         const DataSet& clouds,
         const DataSet& growing,
         std::size_t& left_out)
{
  Benchmark benchmark{describeMachine(), options.measures, {}, {}};
  SharedFigures& shared = benchmark.shared;
  notify ("plain arithmetic");
  shared.arithmetic_speedup = arithmeticSpeedup (options.measures.runs);
  benchmark.clouds = figuresOfAll (clouds, options.measures, left_out);
  shared.peak = peakMemoryOnScan (options.memory_cloud);
  TimesBySize times;
  for (const CloudFigures& figures : benchmark.clouds)
    times[figures.points] = bestOf (figures.times, default_preset);
  if (!options.scaling_folder.empty())
    times = scale (options, clouds, growing);
  shared.growth = growthIn (times);
  notify ("");
  return benchmark;
}

DataSet
growingScans (const std::string& option, const std::string& sizes)
{
  try {
    return evaluation::dataSetOf ("simulated:" + sizes, Eigen::Vector3d::UnitZ());
  }
  catch (const apps::UsageError&) {
    throw apps::UsageError (option,
                            sizes + " is no list of sizes; give some as 30000,300000");
  }
}

int
run (int argc, const char* const* argv)
{
  Options options;
  if (!readOptions (argc, argv, options))
    return apps::ExitCode::done;
  if (options.worst_cases) {
    printWorstCases (
        growingScans ("--worst-case-points", options.worst_case_points).clouds,
        options.measures,
        notify,
        std::cout);
    return apps::ExitCode::done;
  }
  const DataSet clouds =
      evaluation::dataSetOf (options.clouds, Eigen::Vector3d::UnitZ());
  const DataSet growing = growingScans ("--scaling-points", options.scaling_points);
  if (!options.json_file.empty())
    apps::checkWritable (options.json_file);
  if (!options.scaling_folder.empty())
    apps::makeFolder (options.scaling_folder);

  std::size_t left_out = 0;
  const Benchmark benchmark = measure (options, clouds, growing, left_out);
  printReport (benchmark, std::cout);
  if (!options.json_file.empty())
    apps::writeTextFile (options.json_file, jsonOf (benchmark));
  return left_out == 0 ? apps::ExitCode::done : apps::ExitCode::work_failed;
}

} // namespace

int
main (int argc, char** argv)
{
  return apps::runProgram (program_name, [&] { return run (argc, argv); });
}
