// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/common/io.h>

#include <gtest/gtest.h>

#include <benchmark/scaling.h>
#include <simulation/simulated_cloud.h>

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

TEST (Measures, TakeTurnsAndTheShortestRunCounts)
{
  std::string told;
  const std::vector<BestTime> best =
      measureInTurns ({measureTaking ("a", {5.0, 2.0, 4.0}),
                       measureTaking ("b", {7.0, 7.0}),
                       measureTaking ("c", {2.0 * patience, 1.0})}, // too long for more
                      [&] (const std::string& what) { told += what; });
  EXPECT_EQ (told, "abcaba");
  EXPECT_EQ (best[0].durations.detection, 2.0);
  EXPECT_EQ (best[0].runs, 3u);
  EXPECT_EQ (best[2].runs, 1u);
}

TEST (PeakMemory, HoldsAtLeastALabelForEveryPoint)
{
  constexpr std::size_t points = 100'000;
  const pcl_ops::evaluation::XyzCloud::Ptr cloud (new pcl_ops::evaluation::XyzCloud);
  pcl::copyPointCloud (
      pcl_ops::simulation::scanDensely (makeBoards (4), points, 1.0, 1).cloud, *cloud);
  EXPECT_GT (
      peakMemoryOn (cloud, pcl_ops::evaluation::selectConfigurations ("ops").front()),
      4.0 * points);
}

TEST (Boards, EachIsAPlaneOfItsOwn)
{
  const auto scan = pcl_ops::simulation::scanDensely (makeBoards (10), 5000, 0.0, 1);
  EXPECT_EQ (scan.planes.size(), 10u);
  EXPECT_EQ (std::count_if (scan.cloud.begin(),
                            scan.cloud.end(),
                            [] (const auto& point) { return point.label == 10; }),
             500);
}

} // namespace
