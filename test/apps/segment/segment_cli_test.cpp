// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/io/ply_io.h>

#include "segment_program.h"

#include <cmath>
#include <sstream>
#include <utility>

TEST_F (Segment, KeepsFieldsOrderAndSensorPose)
{
  const LabelledCloud cloud = label ("in.pcd");
  EXPECT_NE (cloud[0].rgba, cloud[missing_reading + 1].rgba);
  EXPECT_EQ (cloud[missing_reading].r, 128) << "gray";
  const auto kept = loaded<InputCloud> ("labelled.pcd");
  const InputCloud input = floorAndWall();
  ASSERT_EQ (kept.size(), input.size());
  for (std::size_t i = 0; i < input.size(); ++i)
    ASSERT_EQ (kept[i].intensity, input[i].intensity);
  EXPECT_TRUE (std::isnan (kept[missing_reading].x));
  EXPECT_EQ (kept[points_of_plane - 1].getVector3fMap(),
             input[points_of_plane - 1].getVector3fMap());
  EXPECT_EQ (kept.sensor_origin_, input.sensor_origin_);
}

TEST_F (Segment, GivesTheSameLabelsForEveryFormatAndNumberOfThreads)
{
  const std::vector<std::uint32_t> labels = labelsOf (label ("in.pcd"));
  const InputCloud cloud = floorAndWall();
  pcl::io::savePCDFileASCII (folder_ / "ascii.pcd", cloud);
  pcl::io::savePCDFileBinaryCompressed (folder_ / "compressed.pcd", cloud);
  // A PLY loses the sensor's pose, which the labels do not depend on.
  pcl::io::savePLYFileASCII (folder_ / "ascii.ply", cloud);
  pcl::io::savePLYFileBinary (folder_ / "binary.ply", cloud);
  for (const char* input : {"ascii.pcd", "compressed.pcd", "ascii.ply", "binary.ply"})
    EXPECT_EQ (labelsOf (label (input)), labels) << input;
  EXPECT_EQ (labelsOf (label ("in.pcd", "--threads 4")), labels);
}

TEST_F (Segment, ReplacesColorsUnlessAskedToKeepThem)
{
  LabelledCloud colored;
  pcl::copyPointCloud (floorAndWall(), colored);
  for (pcl::PointXYZRGBL& point : colored)
    point.rgba = 0xff010203;
  pcl::io::savePCDFileBinary (folder_ / "colored.pcd", colored);
  EXPECT_NE (label ("colored.pcd")[0].rgba & 0xffffff, 0x010203u);
  EXPECT_EQ (label ("colored.pcd", "--keep-color")[0].rgba & 0xffffff, 0x010203u);
  EXPECT_NE (label ("in.pcd", "--keep-color")[0].label, 0u) << "harmless without rgb";
}

TEST_F (Segment, WritesPlanesAsJson)
{
  const auto json = jsonOf ("in.pcd --planes p.json -threshold 0.02 --up 0,0,2");
  EXPECT_EQ (json["points"], 2 * points_of_plane + 1);
  EXPECT_EQ (json["method"], "ops");
  EXPECT_EQ (json["parameters"]["threshold"], 0.02);
  for (const char* stage :
       {"search", "normals", "extraction", "assignment", "merging", "detection"})
    EXPECT_GE (json["timing_ms"][stage].get<double>(), 0.0) << stage;
  ASSERT_EQ (json["planes"].size(), 2u);
  const auto& floor = json["planes"][0]["orientation"] == "horizontal"
                          ? json["planes"][0]
                          : json["planes"][1];
  EXPECT_EQ (floor["points"], points_of_plane);
  EXPECT_NEAR (floor["coefficients"][2].get<double>(), 1.0, 1e-6)
      << "towards the sensor";
  EXPECT_NEAR (floor["coefficients"][3].get<double>(), 0.0, 1e-6);
  EXPECT_NEAR (floor["centroid"][0].get<double>(), 0.98, 1e-5);
  EXPECT_NEAR (floor["normal"][2].get<double>(), 1.0, 1e-6);
  EXPECT_NEAR (floor["rms"].get<double>(), 0.0, 1e-6);
  EXPECT_EQ (json["planes"][0]["id"], 1);
}

TEST_F (Segment, DrawsAPictureWithoutADisplay)
{
  expectDone ("in.pcd --image p.png", "env -u DISPLAY -u WAYLAND_DISPLAY");
  const std::string png = contentOf (folder_ / "p.png");
  EXPECT_EQ (png.substr (0, 8), "\x89PNG\r\n\x1a\n");
  EXPECT_EQ (png.substr (png.size() - 8, 4), "IEND");
}

TEST_F (Segment, PrintsATableUnlessQuiet)
{
  const Outcome loud = run ("in.pcd");
  EXPECT_TRUE (contains (loud.out, "5001 points, 2 planes"));
  EXPECT_TRUE (contains (loud.out, "horizontal"));
  EXPECT_TRUE (contains (loud.out, "vertical"));
  EXPECT_TRUE (contains (loud.out, "detection"));
  const Outcome quiet = expectDone ("in.pcd out.pcd --quiet");
  EXPECT_EQ (quiet.out + quiet.err, "");
}

TEST_F (Segment, AnswersHelpOnOneScreen)
{
  const std::string help = run ("--help").out;
  EXPECT_LE (lines (help), 50u);
  std::istringstream stream (help);
  for (std::string line; std::getline (stream, line);)
    EXPECT_LE (line.size(), 80u) << line;
  for (const char* option : {"--s-beta", "--planes-dir"})
    EXPECT_TRUE (contains (help, option)) << option;
  EXPECT_TRUE (contains (run ("--help-all").out, "--s-beta R"));
}

TEST_F (Segment, NoticesAFullStandardOutput)
{
  if (!std::filesystem::exists ("/dev/full"))
    GTEST_SKIP() << "this system has no /dev/full";
  expectRefused ("in.pcd >/dev/full; }", "standard output", 1, "{");
}
