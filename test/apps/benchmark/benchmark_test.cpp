// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/common/point_tests.h>

#include <gtest/gtest.h>

#include <benchmark/boards.h>
#include <benchmark/machine.h>
#include <benchmark/ratios.h>
#include <benchmark/worst_cases.h>
#include <evaluation/data/data_sets.h>
#include <simulation/dense_scan.h>

#include <cctype>
#include <cmath>

namespace {

using namespace pcl_ops::benchmark;

constexpr double not_measured = std::numeric_limits<double>::quiet_NaN();

/** A measure that takes these times, one after the other [ms]. */
Measure
measureTaking (const std::string& name, std::vector<double> times)
{
  const std::size_t runs = times.size();
  return {name, runs, [times, next = std::size_t (0)] () mutable {
            pcl_ops::StageDurations durations;
            durations.detection = times[next++];
            return durations;
          }};
}

BestTimes
measureQuietly (const std::vector<Measure>& measures)
{
  return measureInTurns (
      measures, [] (const std::string&, double) {}, [] (const BestTime&) {});
}

} // namespace

TEST (Ratios, TwoThreadsCountOnlyWhereThereAreTwoCores)
{
  CloudFigures figures;
  figures.times = {{default_preset, {0, 0, 0, 0, 0, 30.0}, 1},
                   {default_on_two_threads, {0, 0, 0, 0, 0, 15.0}, 1}};
  const auto speedup = [&] (double arithmetic) {
    SharedFigures shared;
    shared.arithmetic_speedup = arithmetic;
    for (const Ratio& ratio : ratiosOf (figures, shared))
      if (ratio.id == "two_threads")
        return ratio.value;
    return -1.0;
  };
  EXPECT_EQ (speedup (1.95), 2.0);
  EXPECT_TRUE (std::isnan (speedup (1.1)));
}

TEST (Ratios, MediansLeaveOutWhatWasNotMeasured)
{
  std::vector<std::vector<Ratio>> ratios;
  for (const double value : {5.0, not_measured, 1.0, 3.0})
    ratios.push_back ({{"", "", "", value}, {"", "", "", not_measured}});
  const std::vector<Ratio> medians = mediansOf (ratios);
  EXPECT_EQ (medians[0].value, 3.0);
  EXPECT_TRUE (std::isnan (medians[1].value));
}

TEST (Measures, TheShortestRunCounts)
{
  const BestTimes best = measureQuietly (
      {measureTaking ("a", {5.0, 2.0, 4.0}), measureTaking ("b", {7.0})});
  EXPECT_EQ (bestOf (best, "a"), 2.0);
  EXPECT_EQ (bestOf (best, "b"), 7.0);
  EXPECT_EQ (best[0].runs, 3u);
  EXPECT_TRUE (std::isnan (bestOf (best, "c")));
}

TEST (Measures, WhatTakesVeryLongIsNotRepeated)
{
  const double long_time = 2.0 * patience;
  const BestTimes best = measureQuietly ({measureTaking ("a", {long_time, 1.0})});
  EXPECT_EQ (best[0].runs, 1u);
}

TEST (Measures, AreToldOneByOneAsSoonAsTheyAreFinished)
{
  std::string told;
  measureInTurns (
      {measureTaking ("a", {5.0, 2.0}), measureTaking ("b", {7.0})},
      [&] (const std::string& what, double) { told += what; },
      [&] (const BestTime& time) {
        told += " " + time.name + std::to_string (time.runs) + " ";
      });
  EXPECT_EQ (told, "ab b1 a a2 ");
}

TEST (PeakMemory, HoldsAtLeastALabelForEveryPoint)
{
  constexpr std::size_t points = 100'000;
  const auto scan = pcl_ops::simulation::scanDensely (makeBoards (4), points, 1.0, 1);
  const pcl_ops::evaluation::XyzCloud::Ptr cloud (new pcl_ops::evaluation::XyzCloud);
  for (const pcl::PointXYZL& point : scan.cloud)
    cloud->push_back (pcl::PointXYZ (point.x, point.y, point.z));
  const PeakMemory peak = peakMemoryOn (cloud);
  EXPECT_EQ (peak.cloud_bytes, 16.0 * points);
  EXPECT_GT (peak.extra_bytes, 4.0 * points);
}

/** Of a detector, by its name in the evaluation. */
class WorstCases : public ::testing::TestWithParam<std::string> {};

TEST_P (WorstCases, KeepTheBounds)
{
  // Bounds of time get three times what is promised: other programs run beside tests.
  constexpr double disturbance = 3.0;
  constexpr std::size_t points = 10'000;
  const auto detector = pcl_ops::evaluation::selectConfigurations (GetParam()).front();
  const auto room =
      pcl_ops::evaluation::dataSetOf ("simulated:" + std::to_string (points),
                                      Eigen::Vector3d::UnitZ())
          .clouds.front()
          .load()
          .cloud;
  const double room_bytes = peakMemoryOn (room, detector).extra_bytes;
  for (const WorstCloud& worst : worstClouds()) {
    const WorstCase measured = measureWorstCase (
        detector, worst.name, worst.make (points), room, room_bytes, {});
    EXPECT_LT (measured.timeRatio(), disturbance * time_bound) << worst.name;
    EXPECT_LT (measured.memoryRatio(), memory_bound) << worst.name;
  }
}

INSTANTIATE_TEST_SUITE_P (
    Of,
    WorstCases,
    ::testing::Values (
        "ops", "ops-3-30", "fspf", "fspf-0.07-0.14", "kht", "kht-80-800"),
    [] (const auto& info) {
      std::string name = info.param;
      for (char& letter : name)
        letter = std::isalnum (static_cast<unsigned char> (letter)) ? letter : '_';
      return name;
    });

TEST (WorstClouds, HaveTheirNumberOfFinitePoints)
{
  for (const WorstCloud& worst : worstClouds()) {
    const auto cloud = worst.make (1000);
    EXPECT_EQ (cloud->size(), 1000u) << worst.name;
    for (const pcl::PointXYZ& point : *cloud)
      EXPECT_TRUE (pcl::isFinite (point)) << worst.name;
  }
}

TEST (Boards, EachIsAPlaneOfItsOwn)
{
  const auto scan = pcl_ops::simulation::scanDensely (makeBoards (10), 5000, 0.0, 1);
  EXPECT_EQ (scan.planes.size(), 10u);
  for (const auto& plane : scan.planes)
    EXPECT_EQ (plane.points, 500u);
}

TEST (Machine, IsDescribed)
{
  const Machine machine = describeMachine();
  for (const std::string& text : {machine.cpu, machine.compiler, machine.pcl_version})
    EXPECT_FALSE (text.empty());
  EXPECT_GT (arithmeticSpeedup (1), 0.0);
}
