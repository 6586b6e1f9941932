// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <benchmark/measures.h>
#include <benchmark/peak_memory.h>

namespace {

using namespace pcl_ops::benchmark;

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

std::vector<BestTime>
measureQuietly (const std::vector<Measure>& measures)
{
  return measureInTurns (measures, [] (const std::string&) {});
}

TEST (Measures, TheShortestRunCounts)
{
  const std::vector<BestTime> best = measureQuietly (
      {measureTaking ("a", {5.0, 2.0, 4.0}), measureTaking ("b", {7.0})});
  EXPECT_EQ (best[0].durations.detection, 2.0);
  EXPECT_EQ (best[1].durations.detection, 7.0);
  EXPECT_EQ (best[0].runs, 3u);
}

TEST (Measures, WhatTakesVeryLongIsNotRepeated)
{
  const double long_time = 2.0 * patience;
  const std::vector<BestTime> best =
      measureQuietly ({measureTaking ("a", {long_time, 1.0})});
  EXPECT_EQ (best[0].runs, 1u);
}

TEST (Measures, TakeTurns)
{
  std::string told;
  measureInTurns ({measureTaking ("a", {5.0, 2.0}), measureTaking ("b", {7.0, 7.0})},
                  [&] (const std::string& what) { told += what; });
  EXPECT_EQ (told, "abab");
}

TEST (PeakMemory, HoldsAtLeastALabelForEveryPoint)
{
  namespace evaluation = pcl_ops::evaluation;
  const auto cloud =
      evaluation::dataSetOf ("simulated:100000", Eigen::Vector3d::UnitZ())
          .clouds[0]
          .load()
          .cloud;
  const PeakMemory peak =
      peakMemoryOn (cloud, evaluation::selectConfigurations ("ops").front());
  EXPECT_EQ (peak.cloud_bytes, 1.6e6);
  EXPECT_GT (peak.extra_bytes, 4e5);
}

} // namespace
