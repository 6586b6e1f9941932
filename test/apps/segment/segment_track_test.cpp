// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "segment_program.h"

#include <filesystem>
#include <iomanip>
#include <sstream>

namespace {

constexpr const char* track = "scans --output-dir out --track ";

/** \brief A floor, a wall, and the larger wall of the second scan and the third, whose
 * planes would be numbered otherwise; of the third the sensor has moved by 1 m in x. */
class SegmentTrack : public Segment {
protected:
  SegmentTrack()
  {
    std::filesystem::create_directory (folder_ / "scans");
    const InputCloud first = floorAndWall();
    pcl::io::savePCDFileBinary (folder_ / "scans/a.pcd", first);
    const InputCloud second = withLargerWall();
    pcl::io::savePCDFileBinary (folder_ / "scans/b.pcd", second);
    InputCloud third = second;
    for (auto& point : third)
      point.x -= 1.0f;
    pcl::io::savePCDFileBinary (folder_ / "scans/c.pcd", third);
    folder_.write ("poses.txt",
                   "# timestamp tx ty tz qx qy qz qw\n"
                   "0.0 0 0 0 0 0 0 1\n"
                   "\n"
                   "0.1 0 0 0 0 0 0 1\n"
                   "0.2 1 0 0 0 0 0 1\n");
  }

  static InputCloud
  withLargerWall ()
  {
    InputCloud cloud = floorAndWall();
    constexpr float step = 0.04f;
    for (int y = 0; y < points_of_side; ++y)
      for (int z = points_of_side; z < points_of_side + 20; ++z)
        cloud.push_back (
            {3.0f, step * static_cast<float> (y), step * static_cast<float> (z), 0.0f});
    return cloud;
  }

  /** \brief The number of the floor in a labelled scan. */
  std::uint32_t
  floorIn (const std::string& file) const
  {
    LabelledCloud cloud;
    EXPECT_EQ (pcl::io::loadPCDFile (folder_ / ("out/" + file), cloud), 0);
    const auto labels = distinct (cloud, 0, points_of_plane);
    return labels.size() == 1 ? *labels.begin() : 0;
  }
};

} // namespace

TEST_F (SegmentTrack, GivesAPlaneTheSameLabelAndIdInAllClouds)
{
  expectDone ("scans --output-dir out");
  const std::uint32_t before = floorIn ("a.pcd");
  EXPECT_NE (floorIn ("b.pcd"), before) << "by size";
  expectDone (std::string (track) + "--poses poses.txt");
  for (const char* scan : {"a", "b", "c"}) {
    EXPECT_EQ (floorIn (std::string (scan) + ".pcd"), before) << scan;
    const auto json = jsonIn ("out/" + std::string (scan) + ".json");
    for (const auto& plane : json["planes"])
      EXPECT_EQ (plane["id"] == before, plane["orientation"] == "horizontal") << scan;
  }
}

TEST_F (SegmentTrack, TakesUpInTheFrameThatPosesShare)
{
  // The second camera lies on its side: its y is up, which is z of the others.
  InputCloud turned = withLargerWall();
  for (pcl::PointXYZI& point : turned)
    point.getVector3fMap() = Eigen::Vector3f (point.x, point.z, -point.y);
  turned.sensor_origin_ = Eigen::Vector4f (0.5f, 1.5f, -1.0f, 0.0f);
  pcl::io::savePCDFileBinary (folder_ / "scans/b.pcd", turned);
  folder_.write ("turned.txt",
                 "0 0 0 0 0 0 0 1\n0 0 0 0 0.70710678 0 0 0.70710678\n"
                 "0 1 0 0 0 0 0 1\n");
  for (const char* up : {"", " --up 0,0,1"}) {
    expectDone (track + std::string ("--poses turned.txt") + up);
    const auto json = jsonIn ("out/b.json");
    ASSERT_EQ (json["planes"].size(), 2u);
    EXPECT_NEAR (json["parameters"]["up"][1].get<double>(), 1.0, 1e-6);
    for (const auto& plane : json["planes"])
      EXPECT_EQ (plane["orientation"],
                 std::abs (plane["normal"][1].get<double>()) > 0.9 ? "horizontal"
                                                                   : "vertical");
  }
}

TEST_F (SegmentTrack, GivesAPlaneTheSameColorAndFileInAllClouds)
{
  expectDone (std::string (track) + "--poses poses.txt --planes-dir {}");
  LabelledCloud first, third;
  pcl::io::loadPCDFile (folder_ / "out/a.pcd", first);
  pcl::io::loadPCDFile (folder_ / "out/c.pcd", third);
  EXPECT_EQ (first[0].rgba, third[0].rgba);
  const std::string floor =
      "/plane_00" + std::to_string (floorIn ("a.pcd")) + "_horizontal.pcd";
  for (const char* scan : {"a", "b", "c"})
    EXPECT_TRUE (std::filesystem::exists (folder_ / ("out/" + (scan + floor)))) << scan;
}

TEST_F (SegmentTrack, TakesTheSensorToStandStillWithoutPoses)
{
  expectDone (track);
  EXPECT_EQ (floorIn ("b.pcd"), floorIn ("a.pcd"));
  const auto json = jsonIn ("out/c.json");
  for (const auto& plane : json["planes"])
    if (plane["orientation"] == "vertical") {
      EXPECT_EQ (plane["id"], 3) << "a wall 1 m nearer is another";
    }
}

/** \brief A square of 2 m or 3 m in text, at UTM coordinates. */
std::string
squareText (int points, double z)
{
  std::ostringstream text;
  text << std::fixed << std::setprecision (2);
  for (int x = 0; x < points; ++x)
    for (int y = 0; y < points; ++y)
      text << 500'000 + 0.04 * x << " " << 5'400'000 + 0.04 * y << " " << z << "\n";
  return text.str();
}

TEST_F (SegmentTrack, TellsPlanesApartInDoublePrecisionWhateverElseACloudHas)
{
  // The second square draws the middle of the cloud away from the floor.
  folder_.write ("a.xyz", squareText (50, 0.0));
  folder_.write ("b.xyz", squareText (50, 0.0) + squareText (75, 2.0));
  folder_.write ("c.xyz", squareText (50, 0.5));
  const auto json = jsonOf ("a.xyz b.xyz c.xyz --output-dir out --track", "out/c.json");
  ASSERT_EQ (json["planes"].size(), 1u);
  EXPECT_EQ (json["planes"][0]["id"], 3) << "half a metre above the floor";
}

TEST_F (SegmentTrack, GivesTheSameBytesForAnyNumberOfJobs)
{
  // The first takes so long that the others are through before it.
  pcl::io::savePCDFileBinary (folder_ / "scans/a.pcd", floorAndWall (300));
  const std::string options = std::string (track) + "--poses poses.txt";
  expectDone (options);
  const std::string alone = contentOf (folder_ / "out/c.pcd");
  std::filesystem::remove_all (folder_ / "out");
  expectDone (options + " --jobs 3");
  EXPECT_EQ (contentOf (folder_ / "out/c.pcd"), alone);
}

TEST_F (SegmentTrack, GoesOnAfterABadCloud)
{
  folder_.write ("scans/b.pcd", "no cloud");
  const Outcome done = run (std::string (track) + "--poses poses.txt --jobs 3");
  EXPECT_EQ (done.exit_code, 1);
  EXPECT_EQ (floorIn ("c.pcd"), floorIn ("a.pcd"));
}

TEST_F (SegmentTrack, NamesTheLineThatIsNoPose)
{
  const std::string options = std::string (track) + "--poses bad.txt";
  const std::string good = "0 0 0 0 0 0 0 1\n";
  for (const auto& [line, complaint] : std::vector<std::pair<std::string, std::string>>{
           {"1 2 3", "has 3 numbers"},
           {"0 0 0 0 0 0 0 1 5", "has more than 8 numbers"},
           {"0 0 x 0 0 0 0 1", "has something that is no number in place 3"},
           {"0 0 nan 0 0 0 0 1", "has something that is no number in place 3"},
           {"0 0 1e300 0 0 0 0 1", "has a place more than 1e9 m from zero"},
           {"0 0 0 0 0 0 0 0",
            "has a quaternion qx qy qz qw that is not of length 1"}}) {
    folder_.write ("bad.txt", "# a comment\n" + good + line + "\n" + good);
    expectRefused (options, "bad.txt: line 3 " + complaint, 1);
  }
  folder_.write ("bad.txt", good + good);
  expectRefused (options, "bad.txt: has 2 poses for 3 clouds", 1);
  expectRefused (std::string (track) + "--poses none.txt",
                 "none.txt: does not exist; check the name",
                 1);
  expectRefused (std::string (track) + "--poses scans", "scans: is a folder", 1);
  EXPECT_FALSE (std::filesystem::exists (folder_ / "out/a.pcd"));
}
