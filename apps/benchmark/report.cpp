// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "report.h"

#include <pcl/pcl_config.h>

#include <detection/methods.h>
#include <evaluation/report/text_table.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>

namespace pcl_ops::benchmark {

namespace {

using evaluation::decimal;
using evaluation::TextTable;
using Json = nlohmann::ordered_json;

constexpr double bytes_per_megabyte = 1e6;

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

TextTable
ratioTable (const std::string& title, const std::vector<Ratio>& ratios)
{
  constexpr double large = 20.0;
  TextTable table{title, {"ratio", "value"}, {}};
  for (const Ratio& ratio : ratios) {
    const std::string unit = ratio.unit.empty() ? "" : " [" + ratio.unit + "]";
    table.rows.push_back (
        {ratio.text + unit,
         decimal (ratio.value, std::abs (ratio.value) < large ? 2 : 0)});
  }
  return table;
}

std::string
peakText (const PeakMemory& peak)
{
  return std::to_string (peak.points) + " points take " +
         decimal (peak.cloud_bytes / bytes_per_megabyte, 1) +
         " MB, the default preset " +
         decimal (peak.extra_bytes / bytes_per_megabyte, 1) + " MB more at its peak";
}

/** Bytes read and written per second. */
std::string
bandwidthText (const CloudFigures& figures)
{
  constexpr double gigabytes_per_second = 1e-6; // of bytes per millisecond
  return decimal (2.0 * gigabytes_per_second * figures.peak.cloud_bytes /
                      bestOf (figures.times, cloud_copy),
                  1) +
         " GB/s";
}

/** How all this was measured, as a list. */
void
printMethod (const Benchmark& benchmark, std::ostream& stream)
{
  const MeasureParameters& parameters = benchmark.parameters;
  const unsigned cores = benchmark.shared.cores;
  stream << "- Machine: " << cpuModel() << ", " << cores
         << (cores == 1 ? " core; " : " cores; ") << compilerAndFlags()
         << "; PCL " PCL_VERSION_PRETTY ".\n"
            "- Times are of everything from a loaded cloud to a label for every point, "
            "the search\n  structure's construction and what lies between the stages "
            "included: the shortest of "
         << parameters.runs << "\n  runs";
  if (parameters.peer_runs > 0)
    stream << " (of PCL's and CGAL's detectors " << parameters.peer_runs << ')';
  stream << ", in turns in one process, on one thread where\n  nothing else is said.\n"
            "- Names are those of `pcl_ops_evaluate detectors`: ops is the default "
            "preset, ops-3-30\n  the paper's, with 3 % of the points and 30 "
            "neighbors.\n"
            "- Peak memory is the growth of a child process's resident memory:\n  "
         << peakText (benchmark.shared.peak) << ".\n";
  for (const CloudFigures& figures : benchmark.clouds)
    stream << "- " << figures.name << ": " << peakText (figures.peak)
           << ";\n  a copy of it reads and writes " << bandwidthText (figures) << ".\n";
}

Json
numberOrNull (double number)
{
  return std::isnan (number) ? Json() : Json (number);
}

Json
toArray (const std::vector<Ratio>& ratios)
{
  Json array = Json::array();
  for (const Ratio& ratio : ratios)
    array.push_back ({{"id", ratio.id},
                      {"name", ratio.text},
                      {"unit", ratio.unit.empty() ? Json() : Json (ratio.unit)},
                      {"value", numberOrNull (ratio.value)}});
  return array;
}

Json
toObject (const PeakMemory& peak)
{
  return {{"points", peak.points},
          {"cloud_bytes", numberOrNull (peak.cloud_bytes)},
          {"extra_bytes", numberOrNull (peak.extra_bytes)}};
}

Json
toObject (const CloudFigures& figures, const std::vector<Ratio>& ratios)
{
  Json times = Json::object();
  for (const BestTime& time : figures.times) {
    Json& measure = times[time.name];
    measure["runs"] = time.runs;
    for (const auto& [stage, duration] : apps::detection_stages)
      measure[std::string (stage) + "_ms"] = time.durations.*duration;
  }
  return {{"name", figures.name},
          {"points", figures.points},
          {"times", times},
          {"peak_memory", toObject (figures.peak)},
          {"rows", toArray (ratios)}};
}

} // namespace

void
printTimes (const CloudFigures& figures, std::ostream& stream)
{
  constexpr double microseconds_per_millisecond = 1000.0;
  const auto points = static_cast<double> (figures.points);
  TextTable table{"Times [ms], " + figures.name + ", " +
                      std::to_string (figures.points) + " points",
                  {"measure", "runs"},
                  {}};
  for (const auto& stage : apps::detection_stages)
    table.header.emplace_back (stage.first);
  table.header.emplace_back ("us per point");
  for (const BestTime& time : figures.times) {
    std::vector<std::string> row{time.name, std::to_string (time.runs)};
    for (const auto& [stage, duration] : apps::detection_stages) {
      const double milliseconds = time.durations.*duration;
      row.push_back (milliseconds > 0.0 ? decimal (milliseconds, 1) : "");
    }
    row.push_back (
        decimal (microseconds_per_millisecond * time.durations.detection / points, 3));
    table.rows.push_back (row);
  }
  stream << table;
}

void
printReport (const Benchmark& benchmark, std::ostream& stream)
{
  std::vector<std::vector<Ratio>> ratios;
  for (const CloudFigures& figures : benchmark.clouds) {
    ratios.push_back (ratiosOf (figures, benchmark.shared));
    stream << ratioTable (figures.name + ", " + std::to_string (figures.points) +
                              " points",
                          ratios.back());
  }
  if (ratios.size() > 1)
    stream << ratioTable ("Median over " + std::to_string (ratios.size()) + " clouds",
                          mediansOf (ratios));
  printMethod (benchmark, stream);
}

std::string
jsonOf (const Benchmark& benchmark)
{
  Json json{{"program", "pcl_ops_benchmark"}, {"version", PCL_OPS_VERSION}};
  json["machine"] = {{"cpu", cpuModel()},
                     {"cores", benchmark.shared.cores},
                     {"compiler", compilerAndFlags()},
                     {"pcl", PCL_VERSION_PRETTY}};
  json["runs"] = benchmark.parameters.runs;
  json["peer_runs"] = benchmark.parameters.peer_runs;
  json["seed"] = benchmark.parameters.seed;
  json["peak_memory"] = toObject (benchmark.shared.peak);
  json["clouds"] = Json::array();
  std::vector<std::vector<Ratio>> ratios;
  for (const CloudFigures& figures : benchmark.clouds) {
    ratios.push_back (ratiosOf (figures, benchmark.shared));
    json["clouds"].push_back (toObject (figures, ratios.back()));
  }
  json["rows"] = toArray (mediansOf (ratios));
  return json.dump (2) + "\n";
}

} // namespace pcl_ops::benchmark
