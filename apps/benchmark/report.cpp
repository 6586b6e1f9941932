// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "report.h"

#include <evaluation/report/text_table.h>

#include <cmath>
#include <sstream>

namespace pcl_ops::benchmark {

namespace {

using evaluation::decimal;
using evaluation::TextTable;

constexpr double bytes_per_megabyte = 1e6;

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

} // namespace pcl_ops::benchmark
