// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "time_table.h"

#include <detection/stages.h>

#include <algorithm>

namespace pcl_ops::benchmark {

namespace {

std::vector<std::string>
header ()
{
  std::vector<std::string> names{"measure", "runs"};
  for (const auto& stage : apps::detection_stages)
    names.emplace_back (stage.first);
  names.emplace_back ("us per point");
  return names;
}

/** Wide enough for every measure, and for a time of some minutes. */
std::vector<std::size_t>
widthsFor (const std::vector<Measure>& measures)
{
  constexpr std::size_t width_of_time = 8;
  std::vector<std::size_t> widths (header().size(), width_of_time);
  widths[0] = widths[1] = 0;
  for (const Measure& measure : measures)
    widths[0] = std::max (widths[0], measure.name.size());
  return widths;
}

} // namespace

TimeTable::TimeTable (std::ostream& stream,
                      const std::string& cloud,
                      std::size_t points,
                      const std::vector<Measure>& measures)
: points_ (static_cast<double> (points))
, lines_ (stream,
          "Times [ms], " + cloud + ", " + std::to_string (points) + " points",
          header(),
          widthsFor (measures))
{}

void
TimeTable::add (const BestTime& time)
{
  using evaluation::decimal;
  constexpr double microseconds_per_millisecond = 1000.0;
  std::vector<std::string> row{time.name, std::to_string (time.runs)};
  for (const auto& [stage, duration] : apps::detection_stages) {
    const double milliseconds = time.durations.*duration;
    row.push_back (milliseconds > 0.0 ? decimal (milliseconds, 1) : "");
  }
  row.push_back (
      decimal (microseconds_per_millisecond * time.durations.detection / points_, 3));
  lines_.add (row);
}

void
TimeTable::end()
{
  lines_.end();
}

} // namespace pcl_ops::benchmark
