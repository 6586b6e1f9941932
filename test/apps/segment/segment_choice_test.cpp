// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/io/ply_io.h>

#include "segment_program.h"
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <filesystem>
#include <set>
#include <tuple>

namespace fs = std::filesystem;

namespace {

/** \brief The program with floor.pcd: a floor of 2 m by 2 m, and a board of 0.3 m by
 * 1 m that leans by 30 degrees, two meters above. */
class SegmentChoice : public Segment {
protected:
  SegmentChoice()
  {
    InputCloud scene = floorAndWall();
    scene.resize (points_of_plane);
    for (int i = 0; i < 30; ++i)
      for (int j = 0; j < 50; ++j)
        scene.push_back ({0.02f * static_cast<float> (j),
                          0.01f * static_cast<float> (i),
                          2.0f + 0.02f * 0.57735f * static_cast<float> (j),
                          static_cast<float> (scene.size())});
    pcl::io::savePCDFileBinary (folder_ / "floor.pcd", scene);
  }

  /** \brief The JSON, in which one plane is left, whose number of points is given. */
  nlohmann::json
  expectLeft (const std::string& options, int points) const
  {
    const Outcome done = expectDone ("floor.pcd labelled.pcd --planes - " + options);
    const auto json = nlohmann::json::parse (done.out);
    EXPECT_EQ (json["planes"].size(), 1u) << options;
    EXPECT_EQ (json["planes"][0]["points"], points) << options;
    const LabelledCloud cloud = loaded ("labelled.pcd");
    const bool is_floor = points == points_of_plane;
    EXPECT_EQ (cloud.front().label, is_floor ? 1u : 0u) << options;
    EXPECT_EQ (cloud.back().label, is_floor ? 0u : 1u) << options;
    return json;
  }

  static constexpr int points_of_board = 1500;
};

TEST_F (SegmentChoice, KeepsPlanesByDirectionAndSizeAndSaysWhatWasDropped)
{
  const std::tuple<const char*, const char*, int> rows[] = {
      {"--direction 0,0,2", "direction", points_of_plane},
      {"--direction 1,0,0 --within 70", "direction", points_of_board},
      {"--slope 20,40", "slope", points_of_board},
      {"--min-points 2000", "min_points", points_of_plane},
      {"--min-area 2", "min_area", points_of_plane},
      {"--min-width 0.5", "min_width", points_of_plane},
      {"--max-area 2", "max_area", points_of_board},
      {"--max-width 0.5", "max_width", points_of_board},
      {"--size 1.2,0.3,0.1", "size", points_of_board},
      {"--only other", "only", points_of_board}};
  for (const auto& [options, key, points] : rows) {
    const nlohmann::json dropped = {{"of", 2}, {"by", {{key, 1}}}};
    EXPECT_EQ (expectLeft (options, points)["dropped"], dropped) << options;
  }
}

#ifdef PCL_OPS_WITH_SURFACE
TEST_F (SegmentChoice, TakesTheAreaOfTheHullAskedFor)
{
  expectDone ("floor.pcd out.pcd --hull concave --min-area 2");
}
#endif

TEST_F (SegmentChoice, TakesAnglesUpToARightOne)
{
  for (const char* angle : {"--direction 0,0,1 --within 90", "--angle-tolerance 90"}) {
    expectDone (std::string ("floor.pcd ") + angle);
  }
}

TEST_F (SegmentChoice, IsAmongTheParameters)
{
  const auto json = expectLeft ("--direction 0,0,2 --min-area 1.5", points_of_plane);
  const auto& parameters = json["parameters"];
  EXPECT_EQ (parameters["direction"], (std::vector<double>{0, 0, 2}));
  EXPECT_NEAR (parameters["within"].get<double>(), 10.0, 1e-9);
  EXPECT_EQ (parameters["min_area"], 1.5);
  EXPECT_FALSE (parameters.contains ("min_width"));
  const auto board = expectLeft ("--max-area 1.5", points_of_board)["parameters"];
  EXPECT_EQ (board["max_area"], 1.5);
  const auto sized = expectLeft ("--size 1.2,0.3,0.1", points_of_board)["parameters"];
  EXPECT_EQ (sized["size"], (std::vector<double>{1.2, 0.3, 0.1}));
}

TEST_F (SegmentChoice, KeepsTheLargestOfThoseLeft)
{
  const auto largest = expectLeft ("--max-planes 1", points_of_plane);
  EXPECT_EQ (largest["dropped"].dump(), R"({"by":{"max_planes":1},"of":2})");
  EXPECT_EQ (largest["parameters"]["max_planes"], 1);
  expectLeft ("--max-planes 1 --only other", points_of_board);
  EXPECT_FALSE (contains (run ("floor.pcd --max-planes 2").out, "ropped"));
  EXPECT_TRUE (contains (run ("floor.pcd --max-planes 1").out,
                         "\nDropped 1 of 2 planes: 1 by --max-planes.\n"));
  EXPECT_TRUE (contains (run ("floor.pcd --only largest --max-planes 2").out,
                         "\nDropped 1 of 2 planes: 1 by --only.\n"));
}

TEST_F (SegmentChoice, SaysInALineHowManyPlanesWereDroppedAndWhy)
{
  const Outcome some = run ("floor.pcd --min-width 0.5");
  EXPECT_TRUE (contains (some.out, "\nDropped 1 of 2 planes: 1 by --min-width.\n"));
  const Outcome all = run ("floor.pcd --min-points 2000 --direction 1,0,0");
  EXPECT_TRUE (contains (all.out,
                         "\nNo plane found: all 2 planes found are dropped, 2 by "
                         "--direction: leave an option out or ask for less.\n"));
  EXPECT_FALSE (contains (run ("floor.pcd --min-width 0.1").out, "ropped"));
  const Outcome batch = run ("floor.pcd --output-dir planes --min-area 2");
  EXPECT_TRUE (contains (batch.out,
                         "4000 points, 1 plane. Dropped 1 of 2 planes: 1 by "
                         "--min-area."));
}

TEST_F (SegmentChoice, MeasuresTheOutlineThatIsWritten)
{
  const auto planes = expectLeft ("--min-area 3.8", points_of_plane)["planes"];
  const double area = planes[0]["area"].get<double>();
  EXPECT_GE (area, 3.8);
  const std::string more = std::to_string (area + 0.001);
  EXPECT_TRUE (contains (run ("floor.pcd --min-area " + more).out, "all 2 planes"));
}

/** \brief The program with scene.pcd: floor and wall, and three points in the air. */
class SegmentParts : public Segment {
protected:
  static constexpr int air = 2 * points_of_plane + 1;

  SegmentParts()
  {
    InputCloud scene = floorAndWall();
    for (const float z : {0.7f, 1.0f, 1.3f})
      scene.push_back ({1.0f, 1.0f, z, static_cast<float> (scene.size())});
    pcl::io::savePCDFileBinary (folder_ / "scene.pcd", scene);
  }

  /** \brief The indices in the scene of a written cloud's points. */
  std::vector<int>
  indicesIn (const std::string& file) const
  {
    std::vector<int> indices;
    for (const pcl::PointXYZI& point : loaded<InputCloud> (file))
      indices.push_back (static_cast<int> (point.intensity));
    return indices;
  }
};

using NameSet = std::set<std::string>;

TEST_F (SegmentParts, TheRestIsThePointsOnNoPlaneButNotTheMissingReading)
{
  expectDone ("scene.pcd --rest rest.pcd --quiet");
  EXPECT_EQ (indicesIn ("rest.pcd"), (std::vector<int>{air, air + 1, air + 2}));
  const auto rest = loaded<InputCloud> ("rest.pcd");
  EXPECT_EQ (rest[1].z, 1.0f);
  EXPECT_EQ (rest.sensor_origin_, floorAndWall().sensor_origin_);
}

TEST_F (SegmentParts, TheRestMayBeEmpty)
{
  expectDone ("in.pcd --rest rest.pcd --quiet");
  EXPECT_TRUE (contains (contentOf (folder_ / "rest.pcd"), "\nPOINTS 0\n"));
}

TEST_F (SegmentParts, EachPlaneIsACloudWithTheFieldsOfTheInput)
{
  expectDone ("scene.pcd labelled.pcd --planes-dir planes --quiet");
  const NameSet names = namesIn ("planes");
  ASSERT_EQ (names.size(), 2u);
  const LabelledCloud labelled = loaded ("labelled.pcd");
  for (const std::string& name : names) {
    const std::vector<int> indices = indicesIn ("planes/" + name);
    EXPECT_EQ (indices.size(), static_cast<std::size_t> (points_of_plane)) << name;
    const bool is_floor = contains (name, "horizontal");
    for (const int index : indices) {
      ASSERT_EQ (labelled[index].label, name[8] - '0') << "plane_001_... has label 1";
      ASSERT_EQ (index < points_of_plane, is_floor) << name;
    }
  }
}

TEST_F (SegmentParts, ArePlysWhereAskedFor)
{
  expectDone ("scene.pcd --rest rest.ply --planes-dir planes --quiet");
  InputCloud rest;
  ASSERT_EQ (pcl::io::loadPLYFile (folder_ / "rest.ply", rest), 0);
  ASSERT_EQ (rest.size(), 3u);
  EXPECT_EQ (rest[1].z, 1.0f);
  const std::size_t planes = namesIn ("planes").size();
  expectDone ("scene.pcd --planes-dir planes --format ply --quiet");
  EXPECT_EQ (namesIn ("planes").size(), planes) << "none of the other format is left";
  for (const std::string& name : namesIn ("planes")) {
    InputCloud plane;
    EXPECT_TRUE (contains (name, ".ply"));
    ASSERT_EQ (pcl::io::loadPLYFile (folder_ / ("planes/" + name), plane), 0);
    EXPECT_EQ (plane.size(), static_cast<std::size_t> (points_of_plane));
  }
}

TEST_F (SegmentParts, PlanesOfAnEarlierRunAreGoneAndOtherFilesStay)
{
  fs::create_directory (folder_ / "planes");
  folder_.write ("planes/plane_017_other.pcd", "of a run that found more");
  folder_.write ("planes/plane_of_mine.pcd", "precious");
  folder_.write ("planes/notes.txt", "precious");
  expectDone ("scene.pcd planes/all.pcd --planes-dir planes --only horizontal");
  EXPECT_EQ (
      namesIn ("planes"),
      (NameSet{
          "all.pcd", "notes.txt", "plane_001_horizontal.pcd", "plane_of_mine.pcd"}));
}

TEST_F (SegmentParts, TwoRunsDoNotExchangeThePlanesOfAFolderAtTheSameTime)
{
  fs::create_directory (folder_ / "planes");
  folder_.write ("planes/plane_017_other.pcd", "of another run");
  const int other_run = ::open ((folder_ / "planes").c_str(), O_RDONLY);
  ASSERT_EQ (::flock (other_run, LOCK_EX), 0);
  constexpr int timed_out = 124;
  EXPECT_EQ (run ("scene.pcd --planes-dir planes --quiet", "timeout 0.5").exit_code,
             timed_out);
  EXPECT_EQ (namesIn ("planes"), NameSet{"plane_017_other.pcd"});
  ::close (other_run);
  expectDone ("scene.pcd --planes-dir planes --quiet");
  EXPECT_FALSE (fs::exists (folder_ / "planes/plane_017_other.pcd"));
}

TEST_F (SegmentParts, AFolderWithTheNameOfAPlaneChangesNothing)
{
  expectDone ("scene.pcd --planes-dir planes --quiet");
  const NameSet names = namesIn ("planes");
  ASSERT_EQ (names.size(), 2u);
  // Whichever comes first: one of them is in the way of the other.
  for (const std::string& in_the_way : names) {
    for (const std::string& name : names) {
      fs::remove_all (folder_ / ("planes/" + name));
      if (name == in_the_way)
        fs::create_directory (folder_ / ("planes/" + name));
      else
        folder_.write ("planes/" + name, "precious");
    }
    expectRefused ("scene.pcd --planes-dir planes --quiet",
                   "planes: cannot be written to");
    for (const std::string& name : names)
      if (name != in_the_way) {
        EXPECT_EQ (contentOf (folder_ / ("planes/" + name)), "precious");
      }
  }
}

TEST_F (SegmentParts, PlanesThatAreLeftOutCountAsNone)
{
  const auto planes =
      jsonOf ("scene.pcd labelled.pcd --planes p.json --only vertical --rest rest.pcd")
          ["planes"];
  ASSERT_EQ (planes.size(), 1u);
  EXPECT_EQ (planes[0]["orientation"], "vertical");
  EXPECT_EQ (planes[0]["id"], 1) << "numbered as the labels are";
  const LabelledCloud cloud = loaded ("labelled.pcd");
  EXPECT_EQ (distinct (cloud, 0, missing_reading + 1), std::set<std::uint32_t>{0});
  EXPECT_EQ (distinct (cloud, missing_reading + 1, air), std::set<std::uint32_t>{1});
  EXPECT_EQ (indicesIn ("rest.pcd").size(),
             static_cast<std::size_t> (points_of_plane + 3));
}

TEST_F (SegmentParts, SaysThatTheFilterLeavesNothing)
{
  const Outcome done = expectDone ("scene.pcd --only other");
  EXPECT_TRUE (
      contains (done.out, "No plane found: none of the 2 planes found is other"));
}

} // namespace
