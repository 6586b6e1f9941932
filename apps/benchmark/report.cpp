// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "report.h"

#include <pcl/pcl_config.h>

#include <detection/methods.h>
#include <evaluation/report/text_table.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <thread>

namespace pcl_ops::benchmark {

namespace {

using evaluation::decimal;
using Json = nlohmann::ordered_json;

std::string
cpuModel ()
{
  std::ifstream info ("/proc/cpuinfo");
  for (std::string line; std::getline (info, line);)
    if (line.rfind ("model name", 0) == 0)
      return line.substr (line.find (':') + 2);
  return "unknown CPU";
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

std::string
peakText (const PeakMemory& peak)
{
  constexpr double bytes_per_megabyte = 1e6;
  return std::to_string (peak.points) + " points take " +
         decimal (peak.cloud_bytes / bytes_per_megabyte, 1) +
         " MB, the default preset " +
         decimal (peak.extra_bytes / bytes_per_megabyte, 1) + " MB more at its peak";
}

/** \brief A number that is not one becomes null. */
Json
toObject (const PeakMemory& peak)
{
  return {{"points", peak.points},
          {"cloud_bytes", peak.cloud_bytes},
          {"extra_bytes", peak.extra_bytes}};
}

Json
toObject (const CloudFigures& figures)
{
  Json times = Json::object();
  for (const BestTime& time : figures.times) {
    Json& measure = times[time.name];
    measure["runs"] = time.runs;
    for (const auto& [stage, duration] : apps::detection_stages)
      measure[std::string (stage) + "_ms"] = time.durations.*duration;
  }
  return {{"name", figures.name},
          {"points", figures.peak.points},
          {"times", times},
          {"peak_memory", toObject (figures.peak)}};
}

/** \brief [ms]; of all measures that one is there. */
double
defaultTime (const CloudFigures& figures)
{
  const auto found =
      std::find_if (figures.times.begin(), figures.times.end(), [] (const auto& time) {
        return time.name == default_preset;
      });
  return found->durations.detection;
}

} // namespace

void
printTimes (const CloudFigures& figures, std::ostream& stream)
{
  constexpr double microseconds_per_millisecond = 1000.0;
  const auto points = static_cast<double> (figures.peak.points);
  evaluation::TextTable table{"Times [ms], " + figures.name + ", " +
                                  std::to_string (figures.peak.points) + " points",
                              {"measure", "runs"},
                              {}};
  for (const auto& stage : apps::detection_stages)
    table.header.emplace_back (stage.first);
  table.header.insert (table.header.end(), {"us per point", "times ops"});
  for (const BestTime& time : figures.times) {
    std::vector<std::string> row{time.name, std::to_string (time.runs)};
    for (const auto& [stage, duration] : apps::detection_stages) {
      const double milliseconds = time.durations.*duration;
      row.push_back (milliseconds > 0.0 ? decimal (milliseconds, 1) : "");
    }
    const double whole = time.durations.detection;
    row.push_back (decimal (microseconds_per_millisecond * whole / points, 3));
    row.push_back (decimal (whole / defaultTime (figures), 2));
    table.rows.push_back (row);
  }
  stream << table;
}

void
printMethod (const Benchmark& benchmark, std::ostream& stream)
{
  const MeasureParameters& parameters = benchmark.parameters;
  stream << "- Machine: " << cpuModel() << ", " << std::thread::hardware_concurrency()
         << " cores; " << compilerAndFlags() << "; PCL " PCL_VERSION_PRETTY ".\n"
         << "- Times are of everything from a loaded cloud to a label for every point, "
            "the search\n  structure's construction included: the shortest of "
         << parameters.runs << " runs";
  if (parameters.peer_runs > 0)
    stream << " (of others' detectors " << parameters.peer_runs << ')';
  stream << ", in turns in one process,\n  processor time of one thread where nothing "
            "else is said; of stages and of two\n"
            "  threads wall time.\n"
            "- Names are those of `pcl_ops_evaluate detectors`: ops is the default "
            "preset, ops-3-30\n  the paper's, with 3 % of the points and 30 "
            "neighbors.\n"
            "- Peak memory is the growth of a child process's resident memory:\n  "
         << peakText (benchmark.peak) << ".\n";
  for (const CloudFigures& figures : benchmark.clouds)
    stream << "- " << figures.name << ": " << peakText (figures.peak) << ".\n";
}

std::string
jsonOf (const Benchmark& benchmark)
{
  Json json{{"program", "pcl_ops_benchmark"}, {"version", PCL_OPS_VERSION}};
  json["machine"] = {{"cpu", cpuModel()},
                     {"cores", std::thread::hardware_concurrency()},
                     {"compiler", compilerAndFlags()},
                     {"pcl", PCL_VERSION_PRETTY}};
  json["runs"] = benchmark.parameters.runs;
  json["peer_runs"] = benchmark.parameters.peer_runs;
  json["seed"] = benchmark.parameters.seed;
  json["peak_memory"] = toObject (benchmark.peak);
  json["clouds"] = Json::array();
  for (const CloudFigures& figures : benchmark.clouds)
    json["clouds"].push_back (toObject (figures));
  return json.dump (2) + "\n";
}

} // namespace pcl_ops::benchmark
