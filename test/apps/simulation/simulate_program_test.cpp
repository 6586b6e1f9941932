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

TEST (SimulateProgram, SameSeedSameBytes)
{
  const TemporaryFolder folder;
  for (const char* name : {"a.pcd", "b.pcd"})
    simulate (folder / name + small_image + " -seed 7");
  simulate (folder / "c.pcd" + small_image + " -seed 8");
  EXPECT_EQ (contentOf (folder / "a.pcd"), contentOf (folder / "b.pcd"));
  EXPECT_NE (contentOf (folder / "a.pcd"), contentOf (folder / "c.pcd"));
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

TEST (SimulateProgram, ScansWithTheNumberOfPointsAskedFor)
{
  const TemporaryFolder folder;
  ASSERT_EQ (simulate (folder / "scan.pcd" + " --points 1234").exit_code, 0);
  EXPECT_EQ (loaded (folder / "scan.pcd").size(), 1234u);
}

TEST (SimulateProgram, SimulatesOtherScenes)
{
  const TemporaryFolder folder;
  for (const std::string scene : {"survey", "shapes"}) {
    const std::string file = folder / scene + ".pcd";
    const ProgramRun run =
        simulate (file + " --scene " + scene + " --points 4321 --seed 5");
    ASSERT_EQ (run.exit_code, 0) << run.text;
    EXPECT_EQ (loaded (file).size(), 4321u);
    EXPECT_TRUE (loaded (file).sensor_origin_.isZero());
  }
}

TEST (SimulateProgram, SeesFurnitureAsItSeesARoom)
{
  const TemporaryFolder folder;
  const std::string file = folder / "furniture.pcd";
  const ProgramRun run =
      simulate (file + " --scene furniture --profile raw --organized" + small_image);
  ASSERT_EQ (run.exit_code, 0) << run.text;
  EXPECT_EQ (loaded (file).width, 64u);
  EXPECT_GT (loaded (file).sensor_origin_.z(), 1.0f);
}

TEST (SimulateProgram, SeesAStreetByALidar)
{
  const TemporaryFolder folder;
  const std::string street = " --scene street --sensor lidar-16 --seed 2";
  for (const char* name : {"a.pcd", "b.pcd"})
    ASSERT_EQ (simulate (folder / name + street).exit_code, 0);
  simulate (folder / "rows.pcd" + street + " --organized");
  EXPECT_EQ (contentOf (folder / "a.pcd"), contentOf (folder / "b.pcd"));
  EXPECT_EQ (loaded (folder / "rows.pcd").height, 16u);
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

TEST (SimulateProgram, RefusesWhatNoLidarOrOnlyALidarHas)
{
  const TemporaryFolder folder;
  const std::string output = folder / "street.pcd";
  const std::string street = output + " --scene street";
  expectError (simulate (output + " --sensor livox"), 2, "--sensor");
  expectError (simulate (street + " --sensor sonar"), 2, "--sensor");
  expectError (simulate (street + " --points 9"), 2, "--points");
  expectError (simulate (street + " --width 64"), 2, "--scene");
  expectError (simulate (street + " --profile raw"), 2, "--scene");
  expectError (simulate (street + " --frames 9"), 2, "--frames");
  expectError (simulate (street + " --sensor livox --organized"), 2, "--organized");
  EXPECT_EQ (folder.fileCount(), 0u);
}

TEST (SimulateProgram, OtherScenesSameSeedSameBytes)
{
  const TemporaryFolder folder;
  for (const std::string scene : {"furniture", "survey", "shapes"}) {
    for (const char* name : {"a.pcd", "b.pcd"})
      simulate (folder / name + " --scene " + scene + " --points 999 --seed 3");
    simulate (folder / "c.pcd" + " --scene " + scene + " --points 999 --seed 4");
    EXPECT_EQ (contentOf (folder / "a.pcd"), contentOf (folder / "b.pcd")) << scene;
    EXPECT_NE (contentOf (folder / "a.pcd"), contentOf (folder / "c.pcd")) << scene;
  }
}

TEST (SimulateProgram, ARoomIsTheSceneUnlessAskedFor)
{
  const TemporaryFolder folder;
  simulate (folder / "a.pcd" + small_image);
  simulate (folder / "b.pcd" + small_image + " --scene room");
  EXPECT_EQ (contentOf (folder / "a.pcd"), contentOf (folder / "b.pcd"));
}

TEST (SimulateProgram, RefusesWrongUsage)
{
  const TemporaryFolder folder;
  const std::string output = folder / "room.pcd";
  expectError (simulate (""), 2, "OUTPUT.pcd");
  expectError (simulate (folder / "room.xyz"), 2, folder / "room.xyz");
  expectError (simulate (output + " --profile pink"), 2, "--profile");
  expectError (simulate (output + " --points 0"), 2, "--points");
  expectError (simulate (output + " --points 10000001"), 2, "--points");
  expectError (simulate (output + " --width 8"), 2, "--width");
  expectError (simulate (output + " --height 100000"), 2, "--height");
  expectError (simulate (output + " --noise nan"), 2, "--noise");
  expectError (simulate (output + " --points 9 --organized"), 2, "--points");
  expectError (simulate (output + " --scene garden"), 2, "--scene");
  expectError (simulate (output + " --scene survey --organized"), 2, "--scene");
  expectError (simulate (output + " --colour"), 2, "--colour");
  EXPECT_EQ (folder.fileCount(), 0u);
}

TEST (SimulateProgram, SaysWhyItCannotWrite)
{
  const TemporaryFolder folder;
  expectError (simulate (folder / "absent/room.pcd"), 1, folder / "absent/room.pcd");
  std::filesystem::create_directory (folder / "folder.pcd");
  expectError (simulate (folder / "folder.pcd"), 1, folder / "folder.pcd");
}

TEST (SimulateProgram, AFullDiskLeavesTheOldFile)
{
  const TemporaryFolder folder;
  const std::string file = folder.write ("room.pcd", "precious");
  ProgramRun run =
      runProgram ("/bin/sh",
                  "-c 'trap \"\" XFSZ; ulimit -f 8; " PCL_OPS_SIMULATE_PROGRAM " " +
                      file + small_image + "'");
  run.program = "pcl_ops_simulate"; // and not the shell
  expectError (run, 1, file);
  EXPECT_EQ (contentOf (file), "precious");
  EXPECT_EQ (folder.fileCount(), 1u);
}
