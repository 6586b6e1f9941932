// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <evaluation/data/data_sets.h>
#include <evaluation/detectors/detectors.h>
#include <evaluation/detectors/peers.h>
#include <numbers/random.h>
#include <pcl_ops/detect_planes.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <thread>

namespace {

using namespace pcl_ops::evaluation;
namespace fs = std::filesystem;

/** Adds a level square of \p side x \p side points, 2 cm apart.
 * \param[in] sigma standard deviation of the heights [m] */
void
addSquare (XyzCloud& cloud, int side, double height, double sigma)
{
  pcl_ops::apps::Random random (1);
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j)
      cloud.emplace_back (
          0.02f * i, 0.02f * j, float (height + sigma * random.gaussian()));
}

/** A floor of 60 x 60 points. */
XyzCloud::Ptr
floorWithNoise (double sigma)
{
  XyzCloud::Ptr cloud (new XyzCloud);
  addSquare (*cloud, 60, 0.0, sigma);
  return cloud;
}

TEST (Detectors, EveryOneFindsAFloorAndSaysHowLongItTook)
{
  const XyzCloud::Ptr cloud = floorWithNoise (0.001);
  for (const Configuration& detector :
       selectConfigurations ("presets,peers,peers-measured")) {
    if (detector.needs_image)
      continue;
    const DetectorRun run = detector.run (cloud, {});
    std::vector<std::size_t> points = planeIds (run.labels).points;
    ASSERT_FALSE (points.empty()) << detector.name;
    EXPECT_GT (*std::max_element (points.begin(), points.end()), 3300u)
        << detector.name << ", of 3600 points";
    EXPECT_GT (run.durations.detection, 0.0);
  }
}

TEST (Detectors, OfOthersFindPlanesDownToTheLeastNumberOfPoints)
{
  XyzCloud::Ptr cloud (new XyzCloud);
  addSquare (*cloud, 40, 0.0, 0.001);
  const std::size_t points_of_floor = cloud->size();
  addSquare (*cloud, 7, 1.2, 0.001); // the board: 49 points
  for (const Configuration& detector : selectConfigurations ("peers,peers-measured")) {
    if (detector.needs_image)
      continue;
    for (const std::size_t min_points : {20u, 60u}) {
      RunSettings settings;
      settings.peer_min_points = min_points;
      const PlaneLabels labels = detector.run (cloud, settings).labels;
      const auto on_board =
          std::count_if (labels.begin() + std::ptrdiff_t (points_of_floor),
                         labels.end(),
                         [] (std::uint32_t label) { return label != 0; });
      EXPECT_TRUE (min_points == 20u ? on_board > 40 : on_board == 0)
          << detector.name << ", of at least " << min_points << ": " << on_board;
    }
  }
}

TEST (Detectors, TheDefaultHasMostOfTheRoadOfALidarScanInOnePlane)
{
  // If the road were in pieces, planeKinds would not call it a floor.
  constexpr std::uint32_t road = 40; // class of SemanticKITTI
  const auto file = fs::path (PCL_OPS_DATA_DIR) / "real/lidar64_semkitti_00_000000.pcd";
  if (!fs::exists (file))
    GTEST_SKIP() << "no " << file;
  const EvaluationCloud cloud = dataSetOf ("clouds:" + file.string()).at (0).load();
  const PlaneLabels labels =
      selectConfigurations ("ops").at (0).run (cloud.cloud, {}).labels;
  std::map<std::uint32_t, std::size_t> points_of_plane;
  std::size_t points = 0;
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (cloud.truth->at (i) == road) {
      ++points;
      ++points_of_plane[labels[i]];
    }
  points_of_plane.erase (0);
  std::size_t most = 0;
  for (const auto& [plane, count] : points_of_plane)
    most = std::max (most, count);
  ASSERT_GT (points, 30000u);
  EXPECT_GT (most, points / 2);
}

TEST (Detectors, NoPlaneOfTheDefaultIsThickerThanTwelveNoises)
{
  // Hills consist of pieces that are thin each, but thick when merged. The limit is
  // max_noises_of_plane in src/ops/constants.h.
  int files = 0;
  for (const std::string name : {"lidar/nuscenes_20.pcd",
                                 "lidar/kitti_77.pcd",
                                 "wild/airborne_isprs_fsite8.pcd"}) {
    const auto file = fs::path (PCL_OPS_DATA_DIR) / name;
    if (!fs::exists (file))
      continue;
    ++files;
    const EvaluationCloud cloud = dataSetOf ("clouds:" + file.string()).at (0).load();
    const auto planes = pcl_ops::detectPlanes (
        *cloud.cloud, pcl_ops::OrientedPointSamplingParameters());
    EXPECT_GE (planes.size(), 10u);
    for (const pcl_ops::PlaneSegment& plane : planes)
      EXPECT_LE (plane.rms(), 12.0 * plane.noise.value_or (0.0) * (1.0 + 1e-6)) << name;
  }
  if (files == 0)
    GTEST_SKIP() << "no clouds in " << PCL_OPS_DATA_DIR;
}

TEST (Detectors, ProcessorTimeLeavesOutOtherThreads)
{
  double wall = 0.0, processor = 0.0;
  constexpr double spin_time = 30.0; // [ms]
  const auto spinInAnotherThread = [] {
    std::thread ([] {
      const double start = now (CLOCK_MONOTONIC);
      while (now (CLOCK_MONOTONIC) < start + spin_time) {
      }
    }).join();
  };
  timed (wall, spinInAnotherThread, CLOCK_MONOTONIC);
  timed (processor, spinInAnotherThread);
  EXPECT_GE (wall, spin_time);
  EXPECT_LT (processor, 0.5 * spin_time);
}

TEST (PeerValues, AreThoseOfTheCloudOrAsGiven)
{
  const XyzCloud::Ptr cloud = floorWithNoise (0.002);
  RunSettings settings;
  const PeerValues measured = valuesFor (cloud, settings, ValuesFrom::Cloud);
  EXPECT_NEAR (measured.noise, 0.002, 0.0003);
  EXPECT_NEAR (measured.threshold, 3.0 * measured.noise, 1e-9);
  EXPECT_NEAR (measured.gap, 4.0 * 0.02, 0.02);
  settings.peer_noise = 0.01;
  EXPECT_NEAR (valuesFor (cloud, settings, ValuesFrom::Cloud).threshold, 0.03, 1e-9);
  settings.peer_neighbors = 12;
  EXPECT_EQ (valuesFor (cloud, settings, ValuesFrom::Cloud).neighbors, 12);
  settings.peer_threshold = 0.2;
  EXPECT_EQ (valuesFor (cloud, settings, ValuesFrom::Tutorial).threshold, 0.2);
}

} // namespace
