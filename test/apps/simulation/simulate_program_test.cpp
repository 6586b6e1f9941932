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
  for (const char* output : {"a.pcd --seed 7", "b.pcd --seed 7", "c.pcd --seed 8"})
    ASSERT_EQ (simulate (folder / output + " --points 999").exit_code, 0);
  EXPECT_EQ (contentOf (folder / "a.pcd"), contentOf (folder / "b.pcd"));
  EXPECT_NE (contentOf (folder / "a.pcd"), contentOf (folder / "c.pcd"));
}

TEST (SimulateProgram, HasThePointsAskedFor)
{
  const TemporaryFolder folder;
  const std::string file = folder / "cloud.pcd";
  for (const std::string scene : {"room", "furniture", "survey", "shapes"}) {
    const ProgramRun run = simulate (file + " --points 1234 --scene " + scene);
    ASSERT_EQ (run.exit_code, 0) << run.text;
    EXPECT_EQ (loaded (file).size(), 1234u);
  }
  simulate (file + " --scene street --sensor lidar-16 --organized");
  EXPECT_EQ (loaded (file).height, 16u);
}

TEST (SimulateProgram, RefusesWrongUsage)
{
  const TemporaryFolder folder;
  const std::string output = folder / "room.pcd";
  const std::string street = output + " --scene street";
  const struct {
    std::string arguments, subject;
  } wrong[] = {{"", "OUTPUT.pcd"},
               {folder / "room.xyz", folder / "room.xyz"},
               {output + " --profile pink", "--profile"},
               {output + " --points 0", "--points"},
               {output + " --points 10000001", "--points"},
               {output + " --width 8", "--width"},
               {output + " --height 100000", "--height"},
               {output + " --noise nan", "--noise"},
               {output + " --points 9 --organized", "--points"},
               {output + " --scene garden", "--scene"},
               {output + " --scene survey --organized", "--scene"},
               {output + " --tiles 4", "--tiles"},
               {folder / "walk --scene walk --points 9", "--points"},
               {output + " --colour", "--colour"},
               {output + " --sensor livox", "--sensor"},
               {street + " --sensor sonar", "--sensor"},
               {street + " --points 9", "--points"},
               {street + " --width 64", "--scene"},
               {street + " --profile raw", "--scene"},
               {street + " --frames 9", "--frames"},
               {street + " --sensor livox --organized", "--organized"}};
  for (const auto& [arguments, subject] : wrong) {
    SCOPED_TRACE (arguments);
    expectError (simulate (arguments), 2, subject);
  }
  EXPECT_EQ (folder.fileCount(), 0u);
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
