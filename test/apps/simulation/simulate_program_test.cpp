// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/io/pcd_io.h>
#include <pcl/point_types.h>

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <support/program_folder.h>

#include <fstream>
#include <set>
#include <string>

namespace {

constexpr const char* small_image = " --width 64 --height 48";

class SimulateProgram : public ProgramFolder {
protected:
  SimulateProgram() : ProgramFolder (PCL_OPS_SIMULATE_PROGRAM) {}

  pcl::PointCloud<pcl::PointXYZL>
  loaded (const std::string& file) const
  {
    pcl::PointCloud<pcl::PointXYZL> cloud;
    pcl::io::loadPCDFile (folder_ / file, cloud);
    return cloud;
  }
};

} // namespace

TEST_F (SimulateProgram, WritesALabelledCloudThatPclReadsByTheSeed)
{
  std::set<std::string> contents;
  for (const char* seed : {"7", "7", "8"}) {
    expectDone (std::string ("room.pcd --organized --seed ") + seed + small_image);
    contents.insert (contentOf (folder_ / "room.pcd"));
    const auto cloud = loaded ("room.pcd");
    EXPECT_EQ (cloud.width, 64u);
    EXPECT_EQ (cloud.height, 48u);
    EXPECT_GT (cloud.sensor_origin_.z(), 1.0f);
    std::set<std::uint32_t> labels;
    for (const auto& point : cloud)
      labels.insert (point.label);
    EXPECT_GT (labels.size(), 2u);
  }
  EXPECT_EQ (contents.size(), 2u);
}

TEST_F (SimulateProgram, HasThePointsAndTheSensorAskedFor)
{
  for (const std::string scene : {"room", "furniture", "survey", "shapes"}) {
    expectDone ("cloud.pcd --points 1234 --scene " + scene);
    EXPECT_EQ (loaded ("cloud.pcd").size(), 1234u) << scene;
  }
  expectDone ("cloud.pcd --scene street --sensor lidar-16 --organized");
  EXPECT_EQ (loaded ("cloud.pcd").height, 16u);
}

TEST_F (SimulateProgram, LeavesNoFramesOfALongerWalk)
{
  for (const char* frames : {"3", "2"})
    expectDone (std::string ("walk --scene walk --frames ") + frames + small_image);
  EXPECT_NE (contentOf (folder_ / "walk/frame_001.pcd"), "");
  EXPECT_EQ (contentOf (folder_ / "walk/frame_002.pcd"), "");
}

TEST_F (SimulateProgram, PosesOfADriveLeadToTheRoad)
{
  expectDone ("drive --scene drive --sensor lidar-16 --frames 2 --noise 0");
  std::ifstream poses (folder_ / "drive/poses.txt");
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
    for (const auto& point : loaded (name))
      if (point.label == road &&
          std::abs ((turn * point.getVector3fMap() + from).z()) < 1e-4f)
        ++on_road;
    EXPECT_GT (on_road, 1000u) << name;
  }
}
