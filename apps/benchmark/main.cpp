// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "report.h"
#include "scaling.h"
#include <cli/command_line.h>
#include <cli/errors.h>
#include <cli/program.h>
#include <evaluation/data/data_sets.h>
#include <io/output_file.h>
#include <unistd.h>

#include <filesystem>
#include <iostream>

namespace {

using namespace pcl_ops;
using namespace pcl_ops::benchmark;
using evaluation::DataSet;
using evaluation::XyzCloud;

constexpr const char* program_name = "pcl_ops_benchmark";

/** \brief What the command line says. */
struct Options {
  /** \brief As evaluation::dataSetOf takes them. */
  std::string clouds;
  std::string memory_cloud;
  std::string json_file;
  /** \brief Empty: nothing is measured for it. */
  std::string scaling_folder;
  std::string scaling_points = "30000,100000,300000,1000000,3000000,10000000";
  MeasureParameters measures;
};

/** Simulated clouds are said as data sets; anything else is a path. */
std::string
dataSetText (const std::string& input)
{
  for (const char* kind : {"simulated:",
                           "rooms:",
                           "rooms-raw:",
                           "streets:",
                           "streets-32:",
                           "streets-16:",
                           "sunrgbd:",
                           "sunrgbd-raw:"})
    if (input.rfind (kind, 0) == 0)
      return input;
  return "clouds:" + input;
}

/** \return false if help or version was printed */
bool
readOptions (int argc, const char* const* argv, Options& options)
{
  apps::CommandLine line (
      program_name,
      "Measures how fast planes are found and how much memory that takes, against\n"
      "pcl::KdTreeFLANN's construction and other plane detectors, in one process, and\n"
      "prints it in Markdown.",
      PCL_OPS_VERSION);
  using apps::Range;
  constexpr double max_runs = 1000, max_points = 1e8;
  MeasureParameters& measures = options.measures;
  std::string input;
  std::size_t memory_points = 3'000'000;
  bool no_peers = false;
  line.addArgument (
      "INPUT",
      input,
      "a .pcd, .ply, .las or text file, a folder of them, simulated:N,N,... (scans of "
      "a whole room with N points), rooms:FIRST-LAST, streets:FIRST-LAST (images and "
      "scans by seed) or sunrgbd:FOLDER");
  line.addText ("json", "FILE", options.json_file, "write every number as JSON");
  line.addNumber ("runs",
                  "N",
                  Range::from (1).upTo (max_runs),
                  measures.runs,
                  "take the best of N; what has taken 20 s is not repeated (5)");
  line.addNumber ("peer-runs",
                  "N",
                  Range::from (1).upTo (max_runs),
                  measures.peer_runs,
                  "of others' detectors, which take seconds (1)");
  line.addFlag ("no-peers", no_peers, "leave these out");
  line.addNumber ("seed", "S", Range::from (0), measures.seed, "of detectors (42)");
  line.addNumber ("memory-points",
                  "N",
                  Range::from (1).upTo (max_points),
                  memory_points,
                  "size of the simulated scan peak memory is measured on (3000000)");
  line.addText ("scaling",
                "FOLDER",
                options.scaling_folder,
                "write times over points, threads, sampling rate and planes: "
                "scaling.csv");
  line.addText ("scaling-points",
                "N,N,...",
                options.scaling_points,
                "sizes for that (" + options.scaling_points + ")");
  if (!line.parse (argc, argv))
    return false;
  line.forbidTogether ("no-peers", "peer-runs");
  if (no_peers)
    measures.peer_runs = 0;
  options.clouds = dataSetText (input);
  options.memory_cloud = "simulated:" + std::to_string (memory_points);
  return true;
}

/** Says on a terminal what is being done. */
void
notify (const std::string& what)
{
  constexpr const char* erase_line = "\r\033[K";
  if (isatty (STDERR_FILENO) == 1)
    std::cerr << erase_line << what << std::flush;
}

CloudFigures
figuresOf (const evaluation::CloudSource& source, const MeasureParameters& parameters)
{
  notify ("loading " + source.name);
  const XyzCloud::ConstPtr cloud = source.load().cloud;
  const auto times =
      measureInTurns (measuresOf (cloud, parameters), [&] (const std::string& what) {
        notify (source.name + ": " + what);
      });
  const CloudFigures figures{source.name, times, peakMemoryOn (cloud)};
  notify ("");
  printTimes (figures, std::cout);
  return figures;
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

void
writeScaling (const Options& options, const DataSet& clouds, const DataSet& growing)
{
  const std::vector<ScalingRow> rows =
      measureScaling (clouds.clouds, growing.clouds, options.measures, notify);
  const auto file = std::filesystem::path (options.scaling_folder) / "scaling.csv";
  apps::writeTextFile (file.string(), csvOf (rows));
  notify ("");
}

DataSet
dataSet (const std::string& text)
{
  return evaluation::dataSetOf (text, Eigen::Vector3d::UnitZ());
}

DataSet
growingScans (const std::string& sizes)
{
  try {
    return dataSet ("simulated:" + sizes);
  }
  catch (const apps::UsageError&) {
    throw apps::UsageError ("--scaling-points",
                            sizes + " is no list of sizes; give some as 30000,300000");
  }
}

int
run (int argc, const char* const* argv)
{
  Options options;
  if (!readOptions (argc, argv, options))
    return apps::ExitCode::done;
  const DataSet clouds = dataSet (options.clouds);
  const DataSet growing = growingScans (options.scaling_points);
  if (!options.json_file.empty())
    apps::checkWritable (options.json_file);
  if (!options.scaling_folder.empty())
    apps::makeFolder (options.scaling_folder);

  std::size_t left_out = 0;
  Benchmark benchmark{options.measures, {}, {}};
  benchmark.clouds = figuresOfAll (clouds, options.measures, left_out);
  notify ("memory");
  benchmark.peak =
      peakMemoryOn (dataSet (options.memory_cloud).clouds.front().load().cloud);
  notify ("");
  printMethod (benchmark, std::cout);
  if (!options.scaling_folder.empty())
    writeScaling (options, clouds, growing);
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
