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

TEST_F (Segment, WritesPlanesAsJson)
{
  const auto json = jsonOf ("in.pcd -threshold 0.02 --up 0,0,2");
  EXPECT_EQ (json["points"], 2 * points_of_plane + 1);
  EXPECT_EQ (json["method"], "ops");
  EXPECT_EQ (json["parameters"]["threshold"], 0.02);
  EXPECT_FALSE (json["parameters"].contains ("up_confidence")) << "nobody asked";
  for (const char* stage :
       {"search", "normals", "extraction", "assignment", "merging", "detection"})
    EXPECT_GE (json["timing_ms"][stage].get<double>(), 0.0) << stage;
  ASSERT_EQ (json["planes"].size(), 2u);
  EXPECT_EQ (json["planes"][0]["id"], 1);
  for (const auto& plane : json["planes"]) {
    const bool is_floor = plane["orientation"] == "horizontal";
    const Eigen::Vector3d centroid (is_floor ? 0.98 : 3, 0.98, is_floor ? 0 : 0.98);
    const Eigen::Vector3d normal = toVector (plane["normal"]);
    EXPECT_EQ (plane["points"], points_of_plane);
    EXPECT_TRUE (toVector (plane["centroid"]).isApprox (centroid, 1e-5));
    EXPECT_TRUE (normal.isApprox (Eigen::Vector3d (is_floor ? 0 : -1, 0, is_floor)))
        << "towards the sensor: " << normal.transpose();
    EXPECT_TRUE (toVector (plane["coefficients"]).isApprox (normal));
    EXPECT_NEAR (plane["coefficients"][3].get<double>(), is_floor ? 0.0 : 3.0, 1e-6);
    EXPECT_NEAR (plane["rms"].get<double>(), 0.0, 1e-6);
    const auto& extent = plane["extent"];
    EXPECT_NEAR (plane["area"].get<double>(), 1.96 * 1.96, 1e-5);
    EXPECT_NEAR (extent["length"].get<double>(), 1.96, 1e-5);
    EXPECT_NEAR (extent["width"].get<double>(), 1.96, 1e-5);
    EXPECT_TRUE (toVector (extent["center"]).isApprox (centroid, 1e-5));
    EXPECT_TRUE (toVector (extent["axes"][0])
                     .cross (toVector (extent["axes"][1]))
                     .isApprox (normal, 1e-9));
    ASSERT_GE (plane["hull"].size(), 4u);
    for (const auto& corner : plane["hull"])
      EXPECT_NEAR (
          (toVector (corner) - centroid).lpNorm<Eigen::Infinity>(), 0.98, 1e-5);
  }
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
  for (const char* part :
       {"5001 points, 2 planes", "horizontal", "vertical", "detection"})
    EXPECT_TRUE (contains (loud.out, part));
  const Outcome quiet = expectDone ("in.pcd out.pcd --quiet");
  EXPECT_EQ (quiet.out + quiet.err, "");
}

TEST_F (Segment, SaysWhichOptionToChangeWhereNothingOrLittleIsFound)
{
  InputCloud large = floorAndWall();
  for (pcl::PointXYZI& point : large)
    point.getVector3fMap() *= 1000.0f;
  save ("large.pcd", large);
  // Points 4 cm apart: of the 25 nearest on a plane only the corners are 9 cm away.
  const std::pair<const char*, std::vector<const char*>> rows[] = {
      {"in.pcd --preset paper --sampling-rate 0.001",
       {"No plane found: ", "only 5 of 5000 points", "--sampling-rate"}},
      {"in.pcd --min-inliers 100000 --sampling-rate 1",
       {"No plane found: ", "--min-inliers"}},
      {"in.pcd --method fspf --outer-radius 0.09",
       {"No plane found: ",
        "--outer-radius 0.09 hold 21 points",
        "--local-samples 80"}},
      {"in.pcd --method kht --s-level 9",
       {"No plane found: ", "--s-level 9", "--min-samples 30"}},
      {"large.pcd --method fspf", {"No plane found: ", "millimeter", "--inner-radius"}},
      {"large.pcd --method fspf --threshold 50 --inner-radius 200", {"2 planes"}},
      {"in.pcd --min-inliers 2000",
       {"\n--min-inliers 2000 counts samples, not points, and leaves 0 of 2 planes: "
        "--min-points 2000 counts points\n"}}};
  for (const auto& [arguments, parts] : rows)
    for (const char* part : parts)
      EXPECT_TRUE (contains (expectDone (arguments).out, part));
  for (const std::string fitting :
       {"--min-inliers 21", "--min-points 2000", "--method kht"})
    EXPECT_FALSE (contains (run ("in.pcd " + fitting).out, "counts samples"));
  const auto json = jsonOf ("in.pcd --preset paper --sampling-rate 0.001");
  EXPECT_TRUE (contains (json["advice"], "--sampling-rate"));
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
