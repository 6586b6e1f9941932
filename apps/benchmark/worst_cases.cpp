// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "worst_cases.h"

#include <evaluation/report/text_table.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <functional>
#include <ostream>

namespace pcl_ops::benchmark {

namespace {

using evaluation::Configuration;
using evaluation::decimal;
using evaluation::GrowingTable;
using evaluation::XyzCloud;

/** Of the processor, which other programs do not lengthen. */
StageDurations
timeOf (const std::function<void()>& run)
{
  constexpr double milliseconds_per_second = 1000.0;
  const std::clock_t begin = std::clock();
  run();
  StageDurations durations;
  durations.detection = milliseconds_per_second *
                        static_cast<double> (std::clock() - begin) / CLOCKS_PER_SEC;
  return durations;
}

double
timePerPoint (const BestTime& time, const XyzCloud& cloud)
{
  constexpr double microseconds_per_millisecond = 1000.0;
  return microseconds_per_millisecond * time.durations.detection /
         static_cast<double> (cloud.size());
}

std::vector<std::string>
rowOf (const WorstCase& worst)
{
  constexpr double bytes_per_megabyte = 1e6;
  return {worst.cloud,
          worst.detector,
          decimal (worst.of_room.time_per_point, 2),
          decimal (worst.cost.time_per_point, 2),
          decimal (worst.timeRatio(), 1),
          decimal (worst.of_room.bytes / bytes_per_megabyte, 1),
          decimal (worst.cost.bytes / bytes_per_megabyte, 1),
          decimal (worst.memoryRatio(), 1)};
}

GrowingTable
tableFor (std::size_t points, std::ostream& stream)
{
  constexpr std::size_t width_of_cloud = 20, width_of_detector = 14;
  return {stream,
          "Worst cases, " + std::to_string (points) + " points",
          {"cloud",
           "detector",
           "room [us per point]",
           "cloud [us per point]",
           "ratio",
           "room [MB]",
           "cloud [MB]",
           "ratio"},
          {width_of_cloud, width_of_detector}};
}

/** What is measured on the clouds of one size. */
std::vector<WorstCase>
measureAt (const XyzCloud::ConstPtr& room,
           const MeasureParameters& parameters,
           const Notify& notify,
           const std::function<void (const WorstCase&)>& finish)
{
  const auto detectors = evaluation::selectConfigurations (bounded_detectors);
  std::vector<double> room_bytes;
  for (const Configuration& detector : detectors)
    room_bytes.push_back (peakMemoryOn (room, detector).extra_bytes);
  std::vector<WorstCase> all;
  for (const WorstCloud& worst : worstClouds()) {
    const XyzCloud::ConstPtr cloud = worst.make (room->size());
    for (std::size_t i = 0; i < detectors.size(); ++i) {
      notify (worst.name + ": " + detectors[i].name, 0.0);
      all.push_back (measureWorstCase (
          detectors[i], worst.name, cloud, room, room_bytes[i], parameters));
      notify ("", 0.0);
      finish (all.back());
    }
  }
  return all;
}

/** The largest ratios of those given. */
struct Largest {
  double time = 0.0;
  double memory = 0.0;

  void
  add (const WorstCase& worst)
  {
    time = std::fmax (time, worst.timeRatio());
    memory = std::fmax (memory, worst.memoryRatio());
  }
};

/** A row for each cloud, a column for each detector: the largest over all sizes. */
evaluation::TextTable
largestByDetector (const std::vector<WorstCase>& all)
{
  evaluation::TextTable table{"Largest ratios to a room: time / memory", {"cloud"}, {}};
  const auto detectors = evaluation::selectConfigurations (bounded_detectors);
  for (const Configuration& detector : detectors)
    table.header.push_back (detector.name);
  for (const WorstCloud& cloud : worstClouds()) {
    table.rows.push_back ({cloud.name});
    for (const Configuration& detector : detectors) {
      Largest largest;
      for (const WorstCase& worst : all)
        if (worst.cloud == cloud.name && worst.detector == detector.name)
          largest.add (worst);
      table.rows.back().push_back (decimal (largest.time, 1) + " / " +
                                   decimal (largest.memory, 1));
    }
  }
  return table;
}

void
printLargest (const std::vector<WorstCase>& all, std::ostream& stream)
{
  Largest largest;
  for (const WorstCase& worst : all)
    largest.add (worst);
  stream << largestByDetector (all) << "- Time per point is at most "
         << decimal (largest.time, 1) << " times a room's (meant to stay below "
         << time_bound << "), peak memory without the cloud "
         << decimal (largest.memory, 1) << " times (below " << memory_bound << ")."
         << std::endl;
}

} // namespace

WorstCase
measureWorstCase (const Configuration& detector,
                  const std::string& name,
                  const XyzCloud::ConstPtr& cloud,
                  const XyzCloud::ConstPtr& room,
                  double room_bytes,
                  const MeasureParameters& parameters)
{
  const auto measure_on = [&] (const XyzCloud::ConstPtr& measured) {
    return Measure{detector.name, parameters.runs, [&detector, measured, &parameters] {
                     return timeOf ([&] {
                       detector.run (
                           measured, Eigen::Vector3d::UnitZ(), parameters.seed);
                     });
                   }};
  };
  const BestTimes times = measureInTurns (
      {measure_on (room), measure_on (cloud)},
      [] (const std::string&, double) {},
      [] (const BestTime&) {});
  return {name,
          detector.name,
          {timePerPoint (times[1], *cloud), peakMemoryOn (cloud, detector).extra_bytes},
          {timePerPoint (times[0], *room), room_bytes}};
}

void
printWorstCases (const std::vector<evaluation::CloudSource>& rooms,
                 const MeasureParameters& parameters,
                 const Notify& notify,
                 std::ostream& stream)
{
  std::vector<WorstCase> all;
  for (const evaluation::CloudSource& source : rooms) {
    const XyzCloud::ConstPtr room = source.load().cloud;
    GrowingTable table = tableFor (room->size(), stream);
    const auto measured =
        measureAt (room, parameters, notify, [&] (const WorstCase& worst) {
          table.add (rowOf (worst));
        });
    table.end();
    all.insert (all.end(), measured.begin(), measured.end());
  }
  printLargest (all, stream);
}

} // namespace pcl_ops::benchmark
