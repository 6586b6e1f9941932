// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/common/io.h>

#include "segment_program.h"

#include <cmath>
#include <sstream>

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
  EXPECT_EQ (kept.back().getVector3fMap(), input.back().getVector3fMap());
  EXPECT_EQ (kept.sensor_origin_, input.sensor_origin_);
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

TEST_F (Segment, DrawsAPictureWithoutADisplayAndSaysNothingWhereItIsQuiet)
{
  const Outcome done =
      expectDone ("in.pcd --quiet --image p.png", "env -u DISPLAY -u WAYLAND_DISPLAY");
  EXPECT_EQ (done.out + done.err, "");
  const std::string png = contentOf (folder_ / "p.png");
  EXPECT_EQ (png.substr (0, 8), "\x89PNG\r\n\x1a\n");
  EXPECT_EQ (png.substr (png.size() - 8, 4), "IEND");
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
