// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/pcl_config.h>

#include "measures.h"
#include <cli/command_line.h>
#include <cli/errors.h>
#include <cli/program.h>
#include <detection/methods.h>
#include <evaluate/answer.h>
#include <io/output_file.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <thread>

namespace {

using namespace pcl_ops;
using namespace pcl_ops::benchmark;
using namespace pcl_ops::apps;
using namespace pcl_ops::evaluation;
using Json = nlohmann::ordered_json;

constexpr const char* program_name = "pcl_ops_benchmark";

struct Options {
  /** Text for dataSetOf, or a file or folder of clouds. */
  std::string input;
  std::string json_file;      // for all numbers; empty: not written
  std::string scaling_folder; // for scaling.csv; empty: not measured
  /** Numbers of points of the clouds of the series "points", separated by commas. */
  std::string scaling_points = "30000,100000,300000,1000000,3000000,10000000";
  std::size_t memory_points = 3'000'000; // of the cloud on which memory is measured
  MeasureParameters measures;
};

bool
readOptions (int argc, const char* const* argv, Options& options)
{
  CommandLine line (
      program_name,
      "Measures how fast planes are found and how much memory that takes, against\n"
      "pcl::KdTreeFLANN's construction and other plane detectors, in one process, and\n"
      "prints it in Markdown.",
      PCL_OPS_VERSION);
  const Range runs = from (1).upTo (1000);
  MeasureParameters& measures = options.measures;
  bool no_peers = false;
  line.addArgument (
      "INPUT",
      options.input,
      "a .pcd, .ply, .las or text file, a folder of them, simulated:N,N,... (scans of "
      "a whole room with N points), rooms:FIRST-LAST, streets:FIRST-LAST (images and "
      "scans by seed) or sunrgbd:FOLDER");
  line.add ("json FILE", options.json_file).help ("write every number as JSON");
  line.add ("runs N", measures.runs, runs)
      .help ("take the best of N; what has taken 20 s is not repeated (5)");
  line.add ("peer-runs N", measures.peer_runs, runs)
      .help ("of others' detectors, which take seconds (1)");
  line.add ("no-peers", no_peers).help ("leave these out");
  line.add ("seed S", measures.settings.seed, from (0)).help ("of detectors (42)");
  line.add ("memory-points N", options.memory_points, from (1).upTo (1e8))
      .help ("size of the simulated scan peak memory is measured on (3000000)");
  line.add ("scaling FOLDER", options.scaling_folder)
      .help ("write times over points, threads, sampling rate and planes: "
             "scaling.csv");
  line.add ("scaling-points N,N,...", options.scaling_points)
      .help ("sizes for that (" + options.scaling_points + ")");
  if (!line.parse (argc, argv))
    return false;
  line.forbidTogether ("no-peers", "peer-runs");
  if (no_peers)
    measures.peer_runs = 0;
  return true;
}

/** Shows on a terminal what is measured now, in place of the text before. */
void
notify (const std::string& what)
{
  constexpr const char* erase_line = "\r\033[K";
  if (isatty (STDERR_FILENO) == 1)
    std::cerr << erase_line << what << std::flush;
}

std::string
compilerAndFlags ()
{
#if defined(__clang__)
  return "clang " __clang_version__ " " PCL_OPS_COMPILER_FLAGS;
#elif defined(__GNUC__)
  return "g++ " __VERSION__ " " PCL_OPS_COMPILER_FLAGS;
#else
  return "unknown compiler";
#endif
}

/** Measures the peak memory of the default preset on a cloud. */
Json
peakMemoryOfDefaultOn (const XyzCloud::ConstPtr& cloud)
{
  return {{"points", cloud->size()},
          {"cloud_bytes", double (cloud->size() * sizeof (pcl::PointXYZ))},
          {"extra_bytes", peakMemoryOn (cloud, selectConfigurations ("ops").front())}};
}

/** \param[in] peak result of \ref peakMemoryOfDefaultOn */
std::string
peakText (const Json& peak)
{
  const auto megabytes = [&peak] (const char* key) {
    return decimal (peak[key].get<double>() / 1e6, 1);
  };
  return peak["points"].dump() + " points take " + megabytes ("cloud_bytes") +
         " MB, the default preset " + megabytes ("extra_bytes") +
         " MB more at its peak.\n";
}

/** Measures times and memory on a cloud, prints a table of the times, and returns times
 * and memory. */
Json
figuresOf (const CloudSource& source, const MeasureParameters& parameters)
{
  notify ("loading " + source.name);
  const XyzCloud::ConstPtr cloud = source.load().cloud;
  const auto points = double (cloud->size());
  const std::vector<Measure> measures =
      measureInTurns (measuresOf (cloud, parameters), [&] (const std::string& what) {
        notify (source.name + ": " + what);
      });
  const auto of_default =
      std::find_if (measures.begin(), measures.end(), [] (const Measure& measure) {
        return measure.name == "ops";
      });
  Json figures{{"name", source.name}, {"points", cloud->size()}};
  Json table = Json::array();
  for (const Measure& measure : measures) {
    Json& times = figures["times"][measure.name];
    times["runs"] = measure.runs;
    Json row{{"measure", measure.name}, {"runs", measure.runs}};
    for (const auto& [stage, duration] : detection_stages) {
      const double milliseconds = measure.shortest.*duration;
      times[std::string (stage) + "_ms"] = milliseconds;
      row[stage] = milliseconds > 0.0 ? decimal (milliseconds, 1) : "";
    }
    const double detection = measure.shortest.detection;
    row["us per point"] = decimal (1e3 * detection / points, 3);
    row["times ops"] = decimal (detection / of_default->shortest.detection, 2);
    table.push_back (row);
  }
  figures["peak_memory"] = peakMemoryOfDefaultOn (cloud);
  notify ("");
  const std::string title =
      "Times [ms], " + source.name + ", " + std::to_string (cloud->size()) + " points";
  std::cout << tableOf (title, table) << std::flush;
  return figures;
}

/** Returns \ref figuresOf each cloud. Clouds that cannot be loaded or measured are
 * reported and left out.
 * \param[in,out] left_out number of clouds that are left out
 * \throw WorkError of the last cloud if all are left out */
Json
figuresOfAll (const DataSet& clouds,
              const MeasureParameters& parameters,
              std::size_t& left_out)
{
  Json all = Json::array();
  for (const CloudSource& source : clouds)
    try {
      all.push_back (inMemory (source.name, "give a smaller cloud", [&] {
        return figuresOf (source, parameters);
      }));
    }
    catch (const WorkError& error) {
      if (++left_out == clouds.size())
        throw;
      notify ("");
      warn (std::string ("left out: ") + error.what());
    }
  return all;
}

/** Prints how times and memory were measured, and the memory.
 * \param[in] report all that the file of --json has */
void
printMethodAndMemory (const Json& report)
{
  const Json& machine = report["machine"];
  std::cout
      << "- Machine: " << machine["cpu"].get<std::string>() << ", " << machine["cores"]
      << " cores; " << compilerAndFlags() << "; PCL " PCL_VERSION_PRETTY ".\n"
      << "- Times are of everything from a loaded cloud to a label for every "
         "point, the search\n  structure's construction included: the shortest of "
      << report["runs"] << " runs";
  if (report["peer_runs"] > 0)
    std::cout << " (of others' detectors " << report["peer_runs"] << ')';
  std::cout << R"(, in turns in one process,
  processor time of one thread where nothing else is said; of stages and of two
  threads wall time.
- Names are those of `pcl_ops_evaluate detectors`: ops is the default preset, ops-3-30
  the paper's, with 3 % of the points and 30 neighbors.
- Peak memory is the growth of a child process's resident memory:
  )" << peakText (report["peak_memory"]);
  for (const Json& figures : report["clouds"])
    std::cout << "- " << figures["name"].get<std::string>() << ": "
              << peakText (figures["peak_memory"]);
}

/** \param[in] sizes see Options::scaling_points */
DataSet
scansOfSizes (const std::string& sizes)
{
  try {
    return dataSetOf ("simulated:" + sizes);
  }
  catch (const UsageError&) {
    throw UsageError ("--scaling-points",
                      sizes + " is no list of sizes; give some as 30000,300000");
  }
}

/** Returns the part of the report that is known before the measurement. */
Json
headOfReport (const MeasureParameters& parameters)
{
  const std::string cpu = valueIn ("/proc/cpuinfo", "model name");
  return {{"program", program_name},
          {"version", PCL_OPS_VERSION},
          {"machine",
           {{"cpu", cpu.empty() ? "unknown CPU" : cpu},
            {"cores", std::thread::hardware_concurrency()},
            {"compiler", compilerAndFlags()},
            {"pcl", PCL_VERSION_PRETTY}}},
          {"runs", parameters.runs},
          {"peer_runs", parameters.peer_runs},
          {"seed", parameters.settings.seed}};
}

int
run (int argc, const char* const* argv)
{
  Options options;
  if (!readOptions (argc, argv, options))
    return ExitCode::done;
  const std::string& input = options.input;
  const bool is_path =
      input.find (':') == std::string::npos || std::filesystem::exists (input);
  const DataSet clouds = dataSetOf (is_path ? "clouds:" + input : input);
  const DataSet scans_by_size = scansOfSizes (options.scaling_points);
  if (!options.json_file.empty())
    checkWritable (options.json_file);
  if (!options.scaling_folder.empty())
    makeFolder (options.scaling_folder);

  std::size_t left_out = 0;
  Json report = headOfReport (options.measures);
  report["clouds"] = figuresOfAll (clouds, options.measures, left_out);
  notify ("memory");
  const std::string scan = "simulated:" + std::to_string (options.memory_points);
  report["peak_memory"] = peakMemoryOfDefaultOn (dataSetOf (scan).front().load().cloud);
  notify ("");
  printMethodAndMemory (report);
  if (!options.scaling_folder.empty()) {
    const auto file = std::filesystem::path (options.scaling_folder) / "scaling.csv";
    writeTextFile (file.string(),
                   measureScaling (clouds, scans_by_size, options.measures, notify));
    notify ("");
  }
  if (!options.json_file.empty())
    writeTextFile (options.json_file, report.dump (2) + "\n");
  return left_out == 0 ? ExitCode::done : ExitCode::work_failed;
}

} // namespace

int
main (int argc, char** argv)
{
  return runProgram (program_name, [&] { return run (argc, argv); });
}
