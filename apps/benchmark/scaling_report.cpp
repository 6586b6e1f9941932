// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scaling_report.h"

#include <detection/stages.h>
#include <evaluation/report/gnuplot.h>
#include <io/output_file.h>

#include <algorithm>
#include <filesystem>
#include <sstream>

namespace pcl_ops::benchmark {

namespace {

/** A picture of one series: a line per detector. */
struct SeriesPlot {
  const char* series;
  const char* x_label;
  const char* axes;
  /** Time per point, not of the whole cloud. */
  bool per_point;
};

constexpr SeriesPlot series_plots[] = {
    {over_points, "points", "set logscale xy\n", true},
    {over_threads, "threads", "set xtics 1\nset yrange [0:*]\n", false},
    {over_sampling_rate, "sampling rate [%]", "set logscale xy\n", false},
    {over_planes, "planes", "set logscale xy\n", false}};

std::string
csvOf (const std::vector<ScalingRow>& rows)
{
  std::ostringstream csv;
  csv << "series,x,points,measure,runs";
  for (const auto& stage : apps::detection_stages)
    csv << ',' << stage.first << "_ms";
  csv << '\n';
  for (const ScalingRow& row : rows) {
    csv << row.series << ',' << row.x << ',' << row.points << ',' << row.time.name
        << ',' << row.time.runs;
    for (const auto& [stage, duration] : apps::detection_stages)
      csv << ',' << row.time.durations.*duration;
    csv << '\n';
  }
  return csv.str();
}

/** In the order they come. */
std::vector<std::string>
measuresOf (const std::vector<ScalingRow>& rows, const std::string& series)
{
  std::vector<std::string> names;
  for (const ScalingRow& row : rows)
    if (row.series == series &&
        std::find (names.begin(), names.end(), row.time.name) == names.end())
      names.push_back (row.time.name);
  return names;
}

/** Columns: what grows, time [ms], or [us] per point; a block per detector. */
evaluation::Plot
plotOf (const std::vector<ScalingRow>& rows, const SeriesPlot& kind)
{
  constexpr double microseconds_per_millisecond = 1000.0;
  evaluation::Plot plot{std::string ("time_over_") + kind.series, "", ""};
  plot.commands = std::string (kind.axes) + "set xlabel '" + kind.x_label +
                  "'\nset ylabel '" +
                  (kind.per_point ? "time per point [us]" : "time [ms]") + "'\nplot ";
  std::ostringstream data;
  int block = 0;
  for (const std::string& name : measuresOf (rows, kind.series)) {
    data << "# " << name << '\n';
    for (const ScalingRow& row : rows) {
      if (row.series != kind.series || row.time.name != name)
        continue;
      const double time = row.time.durations.detection;
      const auto points = static_cast<double> (row.points);
      data << row.x << ' '
           << (kind.per_point ? microseconds_per_millisecond * time / points : time)
           << '\n';
    }
    data << "\n\n";
    plot.commands += (block > 0 ? ", '" : "'") + plot.name + ".dat' index " +
                     std::to_string (block) + " title '" + name + "' with linespoints";
    ++block;
  }
  plot.commands += '\n';
  plot.data = data.str();
  return plot;
}

} // namespace

bool
writeScaling (const std::vector<ScalingRow>& rows, const std::string& folder)
{
  apps::writeTextFile ((std::filesystem::path (folder) / "scaling.csv").string(),
                       csvOf (rows));
  bool all_drawn = true;
  for (const SeriesPlot& kind : series_plots)
    all_drawn = evaluation::writePlot (plotOf (rows, kind), folder) && all_drawn;
  return all_drawn;
}

} // namespace pcl_ops::benchmark
