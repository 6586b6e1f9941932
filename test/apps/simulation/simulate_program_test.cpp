// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/io/pcd_io.h>
#include <pcl/point_types.h>

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <support/run_program.h>
#include <support/temporary_folder.h>

#include <algorithm>
#include <fstream>
#include <set>
#include <string>

namespace {

constexpr const char* small_image = " --width 64 --height 48";

ProgramRun
simulate (const std::string& arguments)
{
  return runProgram (PCL_OPS_SIMULATE_PROGRAM, arguments);
}

pcl::PointCloud<pcl::PointXYZL>
loaded (const std::string& file)
{
  pcl::PointCloud<pcl::PointXYZL> cloud;
  pcl::io::loadPCDFile (file, cloud);
  return cloud;
}

} // namespace

TEST (SimulateProgram, WritesALabelledCloudThatPclReads)
{
  const TemporaryFolder folder;
  const std::string file = folder / "room.pcd";
  ASSERT_EQ (simulate (file + small_image + " --organized").exit_code, 0);
  const auto cloud = loaded (file);
  EXPECT_EQ (cloud.width, 64u);
  EXPECT_EQ (cloud.height, 48u);
  EXPECT_TRUE (std::any_of (
      cloud.begin(), cloud.end(), [] (const auto& point) { return point.label > 1; }));
  EXPECT_GT (cloud.sensor_origin_.z(), 1.0f);
}

TEST (SimulateProgram, HasThePointsAskedForByTheSeed)
{
  const TemporaryFolder folder;
  const std::string file = folder / "cloud.pcd";
  for (const std::string scene : {"room", "furniture", "survey", "shapes"}) {
    std::set<std::string> contents;
    for (const char* seed : {"7", "7", "8"}) {
      const ProgramRun run =
          simulate (file + " --points 1234 --scene " + scene + " --seed " + seed);
      ASSERT_EQ (run.exit_code, 0) << run.text;
      EXPECT_EQ (loaded (file).size(), 1234u);
      contents.insert (contentOf (file));
    }
    EXPECT_EQ (contents.size(), 2u) << scene;
  }
  simulate (file + " --scene street --sensor lidar-16 --organized");
  EXPECT_EQ (loaded (file).height, 16u);
}

TEST (SimulateProgram, LeavesNoFramesOfALongerWalk)
{
  const TemporaryFolder folder;
  const std::string walk = folder / "walk" + " --scene walk" + small_image;
  ASSERT_EQ (simulate (walk + " --frames 3").exit_code, 0);
  ASSERT_EQ (simulate (walk + " --frames 2").exit_code, 0);
  EXPECT_NE (contentOf (folder / "walk/frame_001.pcd"), "");
  EXPECT_EQ (contentOf (folder / "walk/frame_002.pcd"), "");
}

TEST (SimulateProgram, PosesOfADriveLeadToTheRoad)
{
  const TemporaryFolder folder;
  const ProgramRun run = simulate (
      folder / "drive" + " --scene drive --sensor lidar-16 --frames 2 --noise 0");
  ASSERT_EQ (run.exit_code, 0) << run.text;
  std::ifstream poses (folder / "drive/poses.txt");
  std::string comment;
  std::getline (poses, comment);
  for (const char* name : {"drive/frame_000.pcd", "drive/frame_001.pcd"}) {
    double time = 0.0;
    Eigen::Vector3f from;
    Eigen::Quaternionf turn;
    poses >> time >> from.x() >> from.y() >> from.z() >> turn.x() >> turn.y() >>
        turn.z() >> turn.w();
    constexpr std::uint32_t road = 1; // a street's first surface
    std::size_t on_road = 0;
    for (const auto& point : loaded (folder / name))
      if (point.label == road &&
          std::abs ((turn * point.getVector3fMap() + from).z()) < 1e-4f)
        ++on_road;
    EXPECT_GT (on_road, 1000u) << name;
  }
}
