// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud/sorted_points.h"
#include "grid_scene.h"

using namespace pcl_ops::internal;

namespace {

/** \brief The runs of points on the x axis with these x [m], in voxels of 1 m. */
PointRuns
runsAlongX (const std::vector<float>& xs)
{
  Coordinates points;
  for (const float x : xs)
    points.add (x, 0.0f, 0.0f);
  return sortedRuns (points, 1_m, one_thread);
}

} // namespace

TEST (SortedRuns, JoinPointsThatFollowEachOtherInAVoxel)
{
  const PointRuns runs = runsAlongX ({5.5f, 0.1f, 0.9f, 0.2f});
  ASSERT_EQ (runs.size(), 2u);
  EXPECT_EQ (runs[0].first(), 1u);
  EXPECT_EQ (runs[0].size(), 3u);
  EXPECT_EQ (runs[1].first(), 0u);
  EXPECT_EQ (runs[0].code(), mortonCode (0, 0, 0));
  EXPECT_EQ (runs[1].code(), mortonCode (5, 0, 0));
}

TEST (SortedRuns, HaveAtMostSixteenPoints)
{
  EXPECT_EQ (runsAlongX ({}).size(), 0u);
  const PointRuns runs = runsAlongX (std::vector<float> (35, 0.5f));
  ASSERT_EQ (runs.size(), 3u) << "35 = 16 + 16 + 3";
  EXPECT_EQ (runs[0].end(), runs[1].first());
  EXPECT_EQ (runs[1].end(), runs[2].first());
  EXPECT_EQ (runs[2].size(), 3u);
}

TEST (SortedRuns, OfAVoxelComeInTheOrderOfTheirPoints)
{
  const PointRuns runs = runsAlongX ({0.1f, 5.5f, 0.9f, 5.1f, 0.2f});
  ASSERT_EQ (runs.size(), 5u);
  const std::vector<std::uint32_t> expected_points{0, 2, 4, 1, 3};
  for (std::size_t i = 0; i < runs.size(); ++i)
    EXPECT_EQ (runs[i].first(), expected_points[i]);
}

TEST (SortedRuns, AscendAndCoverEveryPointOnce)
{
  // Points near each other, and one so far away that codes need all their bits.
  Coordinates points = pointsInACube (40000, 4.0);
  points.add (1e9f, -1e9f, 1e9f);
  std::vector<int> runs_with_point (points.size(), 0);
  MortonCode previous_code = 0;
  const PointRuns runs = sortedRuns (points, 0.1, one_thread);
  for (const PointRun& run : runs) {
    EXPECT_LE (previous_code, run.code());
    previous_code = run.code();
    for (std::uint32_t i = run.first(); i < run.end(); ++i)
      ++runs_with_point[i];
  }
  EXPECT_EQ (runs_with_point, std::vector<int> (points.size(), 1));
}
