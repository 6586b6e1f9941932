// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "options.h"

#include <cli/command_line.h>
#include <cli/errors.h>

#include <algorithm>
#include <array>

namespace pcl_ops::benchmark {

namespace {

using apps::Range;

constexpr double most_runs = 1000;
constexpr double most_points = 1e8;

/** Simulated clouds are said as data sets; anything else is a path. */
std::string
dataSetText (const std::string& input)
{
  constexpr std::array<const char*, 3> simulated{"simulated:", "rooms:", "rooms-raw:"};
  const bool is_simulated =
      std::any_of (simulated.begin(), simulated.end(), [&] (const char* kind) {
        return input.rfind (kind, 0) == 0;
      });
  return is_simulated ? input : "clouds:" + input;
}

void
declareMeasures (apps::CommandLine& line, MeasureParameters& measures, bool& no_peers)
{
  line.addNumber ("runs",
                  "N",
                  Range::from (1).upTo (most_runs),
                  measures.runs,
                  "take the best of N; what has taken 20 s is not repeated (5)");
  line.addNumber ("peer-runs",
                  "N",
                  Range::from (1).upTo (most_runs),
                  measures.peer_runs,
                  "of PCL's and CGAL's detectors, which take seconds (1)");
  line.addFlag ("no-peers", no_peers, "leave these out");
  line.addNumber ("seed", "S", Range::from (0), measures.seed, "of detectors (42)");
}

void
declareScaling (apps::CommandLine& line, Options& options)
{
  line.addText ("scaling",
                "FOLDER",
                options.scaling_folder,
                "write times over points, threads, sampling rate and planes: CSV and "
                "gnuplot");
  line.addText ("scaling-points",
                "N,N,...",
                options.scaling_points,
                "sizes for that (" + options.scaling_points + ")");
}

void
declareWorstCases (apps::CommandLine& line, Options& options)
{
  line.addFlag ("worst-cases",
                options.worst_cases,
                "without INPUT: time and memory on noise, exact planes and others that "
                "are hard, against a room's");
  line.addText ("worst-case-points",
                "N,N,...",
                options.worst_case_points,
                "sizes for that (" + options.worst_case_points + ")");
}

/** \throw apps::UsageError unless there is either an input or nothing to do with one */
void
checkInput (const apps::CommandLine& line, const Options& options)
{
  if (options.worst_cases == !options.clouds.empty())
    throw apps::UsageError ("INPUT",
                            options.worst_cases
                                ? "is not for --worst-cases; leave one of them out"
                                : "is missing; see --help");
  if (!options.worst_cases)
    return;
  for (const char* other :
       {"json", "scaling", "scaling-points", "memory-points", "no-peers", "peer-runs"})
    line.forbidTogether ("worst-cases", other);
}

} // namespace

bool
readOptions (int argc, const char* const* argv, Options& options)
{
  apps::CommandLine line (
      program_name,
      "Measures how fast planes are found and how much memory that takes, against\n"
      "pcl::KdTreeFLANN's construction and other plane detectors, in one process, and\n"
      "prints it in Markdown.",
      PCL_OPS_VERSION);
  std::string input;
  std::size_t memory_points = 3'000'000;
  bool no_peers = false;
  line.addOptionalArgument (
      "INPUT",
      input,
      "a .pcd, .ply, .las or text file, a folder of them, simulated:N,N,... (scans of "
      "a whole room with N points) or rooms:FIRST-LAST (depth images by "
      "seed)");
  line.addText ("json", "FILE", options.json_file, "write every number as JSON");
  declareMeasures (line, options.measures, no_peers);
  line.addNumber ("memory-points",
                  "N",
                  Range::from (1).upTo (most_points),
                  memory_points,
                  "size of the simulated scan peak memory is measured on (3000000)");
  declareScaling (line, options);
  declareWorstCases (line, options);
  if (!line.parse (argc, argv))
    return false;
  line.forbidTogether ("no-peers", "peer-runs");
  if (no_peers)
    options.measures.peer_runs = 0;
  options.clouds = input.empty() ? "" : dataSetText (input);
  checkInput (line, options);
  options.memory_cloud = "simulated:" + std::to_string (memory_points);
  return true;
}

} // namespace pcl_ops::benchmark
