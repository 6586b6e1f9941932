// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "report.h"

#include <detection/stages.h>
#include <evaluation/report/text_table.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace pcl_ops::benchmark {

namespace {

using evaluation::decimal;
using evaluation::TextTable;

constexpr double bytes_per_megabyte = 1e6;

/** Enough digits to compare with the bounds. */
std::string
shortNumber (double number)
{
  constexpr double large = 20.0;
  return decimal (number, std::abs (number) < large ? 2 : 0);
}

std::string
boundText (const Target& target, double bound)
{
  return std::isnan (bound)
             ? ""
             : (target.less_is_better ? "<= " : ">= ") + shortNumber (bound);
}

TextTable
targetTable (const std::string& title, const std::vector<TargetRow>& rows)
{
  TextTable table{title, {"ratio", "value", "target", "hoped for", "reached"}, {}};
  for (const TargetRow& row : rows) {
    const Target& target = row.target;
    const std::string unit = target.unit.empty() ? "" : " [" + target.unit + "]";
    table.rows.push_back ({target.text + unit,
                           shortNumber (row.value),
                           boundText (target, target.target),
                           boundText (target, target.hoped_for),
                           toString (reachedBy (row))});
  }
  return table;
}

TextTable
timeTable (const CloudFigures& figures)
{
  constexpr double microseconds_per_millisecond = 1000.0;
  TextTable table{"Times [ms], " + figures.name, {"measure", "runs"}, {}};
  for (const auto& stage : apps::kStages)
    table.header.emplace_back (stage.first);
  table.header.emplace_back ("us per point");
  for (const BestTime& time : figures.times) {
    std::vector<std::string> row{time.name, std::to_string (time.runs)};
    for (const auto& [stage, duration] : apps::kStages) {
      const double milliseconds = time.durations.*duration;
      row.push_back (milliseconds > 0.0 ? decimal (milliseconds, 1) : "");
    }
    row.push_back (decimal (microseconds_per_millisecond * time.durations.detection /
                                static_cast<double> (figures.points),
                            3));
    table.rows.push_back (std::move (row));
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

/** An item of a Markdown list, broken into lines. */
void
printItem (const std::string& text, std::ostream& stream)
{
  constexpr std::size_t width = 88;
  std::istringstream words (text);
  std::string line = "-";
  for (std::string word; words >> word;) {
    if (line.size() + 1 + word.size() > width) {
      stream << line << '\n';
      line = " ";
    }
    line += " " + word;
  }
  stream << line << '\n';
}

std::string
machineText (const Machine& machine)
{
  return "Machine: " + machine.cpu + ", " + std::to_string (machine.cores) +
         (machine.cores == 1 ? " core; " : " cores; ") + machine.compiler + "; PCL " +
         machine.pcl_version + ".";
}

std::string
timesText (const MeasureParameters& parameters)
{
  const std::string peers = parameters.peer_runs == 0
                                ? ""
                                : " (of PCL's and CGAL's detectors " +
                                      std::to_string (parameters.peer_runs) + ")";
  return "Times are of everything from a loaded cloud to a label for every point, the "
         "search structure's construction and what lies between the stages included: "
         "the shortest of " +
         std::to_string (parameters.runs) + " runs" + peers +
         ", in turns in one process, on one thread where nothing else is said.";
}

void
printMethod (const Benchmark& benchmark, std::ostream& stream)
{
  printItem (machineText (benchmark.machine), stream);
  printItem (timesText (benchmark.parameters), stream);
  printItem ("Names are those of `pcl_ops_evaluate detectors`: ops is the default "
             "preset, ops-3-30 the paper's, with 3 % of the points and 30 neighbours.",
             stream);
  printItem ("Two threads do plain arithmetic " +
                 decimal (benchmark.shared.arithmetic_speedup, 2) +
                 " times as fast as one; below " + decimal (speedup_of_two_cores, 1) +
                 " there are no two real cores to measure on.",
             stream);
  printItem ("Peak memory is the growth of a child process's resident memory: " +
                 peakText (benchmark.shared.peak) + ".",
             stream);
  for (const CloudFigures& figures : benchmark.clouds)
    printItem (figures.name + ": " + peakText (figures.peak) +
                   "; a copy of it reads and writes " + bandwidthText (figures) + ".",
               stream);
}

} // namespace

void
printReport (const Benchmark& benchmark, std::ostream& stream)
{
  std::vector<std::vector<TargetRow>> rows;
  for (const CloudFigures& figures : benchmark.clouds) {
    rows.push_back (rowsOf (figures, benchmark.shared));
    stream << targetTable (figures.name + ", " + std::to_string (figures.points) +
                               " points",
                           rows.back())
           << timeTable (figures);
  }
  if (rows.size() > 1)
    stream << targetTable ("Median over " + std::to_string (rows.size()) + " clouds",
                           mediansOf (rows));
  printMethod (benchmark, stream);
}

} // namespace pcl_ops::benchmark
