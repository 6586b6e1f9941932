// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "segment_program.h"
#include <fcntl.h>
#include <support/cloud_values.h>
#include <sys/file.h>
#include <unistd.h>

#include <filesystem>

namespace fs = std::filesystem;

namespace {

using Json = nlohmann::json;

/** \brief The program with floor.pcd: a floor of 2 m by 2 m, and a board of 0.3 m by
 * 1 m that leans by 30 degrees, two meters above. */
class SegmentChoice : public Segment {
protected:
  SegmentChoice()
  {
    InputCloud scene = floorAndWall();
    scene.resize (points_of_plane);
    addGrid (scene, {0, 0, 2}, {0, 0.01f, 0}, 30, {0.02f, 0, 0.02f * 0.57735f}, 50);
    save ("floor.pcd", scene);
  }

  /** \brief The JSON, in which one plane is left, the floor or the board. */
  Json
  expectLeft (const std::string& options, bool is_floor) const
  {
    Json json = jsonOf ("floor.pcd labelled.pcd " + options);
    EXPECT_EQ (json["planes"].size(), 1u) << options;
    EXPECT_EQ (json["planes"][0]["points"], is_floor ? points_of_plane : 1500);
    const LabelledCloud cloud = loaded ("labelled.pcd");
    EXPECT_EQ (cloud.front().label, is_floor ? 1u : 0u) << options;
    EXPECT_EQ (cloud.back().label, is_floor ? 0u : 1u) << options;
    return json;
  }
};

TEST_F (SegmentChoice, KeepsPlanesAndReportsTheOptionAndWhatWasDropped)
{
  const struct {
    std::string options, key;
    Json value;
    bool is_floor;
  } rows[] = {{"--direction 0,0,2", "direction", {0.0, 0.0, 2.0}, true},
              {"--direction 1,0,0 --within 70", "direction", {1.0, 0.0, 0.0}, false},
              {"--slope 20,40", "slope", {20.0, 40.0}, false},
              {"--min-points 2000", "min_points", 2000, true},
              {"--min-area 2", "min_area", 2.0, true},
              {"--min-width 0.5", "min_width", 0.5, true},
              {"--max-area 2", "max_area", 2.0, false},
              {"--max-width 0.5", "max_width", 0.5, false},
              {"--size 1.2,0.3,0.1", "size", {1.2, 0.3, 0.1}, false},
              {"--max-planes 1", "max_planes", 1, true},
              {"--only other", "only", "other", false}};
  for (const auto& [options, key, value, is_floor] : rows) {
    const Json json = expectLeft (options, is_floor);
    EXPECT_EQ (json["dropped"], (Json{{"of", 2}, {"by", {{key, 1}}}})) << options;
    EXPECT_EQ (json["parameters"][key], value);
    EXPECT_EQ (json["parameters"].contains ("min_width"), key == "min_width");
    EXPECT_EQ (json["parameters"].value ("within", 0.0),
               key != "direction" ? 0.0
               : is_floor         ? 10.0
                                  : 70.0);
  }
  expectLeft ("--max-planes 1 --only other", false);
}

TEST_F (SegmentChoice, SaysInALineHowManyPlanesWereDroppedAndWhy)
{
  const std::pair<const char*, const char*> rows[] = {
      {"--min-width 0.5", "\nDropped 1 of 2 planes: 1 by --min-width.\n"},
      {"--max-planes 1", "\nDropped 1 of 2 planes: 1 by --max-planes.\n"},
      {"--only largest --max-planes 2", "\nDropped 1 of 2 planes: 1 by --only.\n"},
      {"--min-points 2000 --direction 1,0,0",
       "\nNo plane found: all 2 planes found are dropped, 2 by --direction: leave an "
       "option out or ask for less.\n"},
      {"--only vertical", "\nNo plane found: none of the 2 planes found is vertical"},
      {"--output-dir planes --min-area 2",
       "4000 points, 1 plane. Dropped 1 of 2 planes: 1 by --min-area."}};
  for (const auto& [options, line] : rows)
    EXPECT_TRUE (contains (run (std::string ("floor.pcd ") + options).out, line));
  for (const char* options : {"--max-planes 2", "--min-width 0.1"})
    EXPECT_FALSE (contains (run (std::string ("floor.pcd ") + options).out, "ropped"));
}

TEST_F (SegmentChoice, MeasuresTheOutlineThatIsWritten)
{
  const double area =
      expectLeft ("--min-area 3.8", true)["planes"][0]["area"].get<double>();
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
    addGrid (scene, {1.0f, 1.0f, 0.7f}, {0, 0, 0.3f}, 3, {0, 0, 0}, 1);
    save ("scene.pcd", scene);
  }

  /** \brief The indices in the scene of a written cloud's points. */
  std::vector<float>
  indicesIn (const std::string& file) const
  {
    return valuesOf<float> (pcl_ops::apps::loadCloud (folder_ / file), "intensity");
  }
};

using Names = std::set<std::string>;

TEST_F (SegmentParts, AreTheRestWithoutTheMissingReadingAndACloudForEachPlane)
{
  for (const std::string format : {"pcd", "ply"}) {
    const std::string rest = "rest." + format;
    expectDone ("scene.pcd labelled.pcd --planes-dir planes --format " + format +
                " --rest " + rest);
    EXPECT_EQ (indicesIn (rest), (std::vector<float>{air, air + 1, air + 2}));
    const Names names = namesIn ("planes");
    ASSERT_EQ (names.size(), 2u) << "none of the other format is left";
    const LabelledCloud labelled = loaded ("labelled.pcd");
    for (const std::string& name : names) {
      EXPECT_TRUE (contains (name, "." + format));
      const std::vector<float> indices = indicesIn ("planes/" + name);
      EXPECT_EQ (indices.size(), std::size_t (points_of_plane)) << name;
      const bool is_floor = name.find ("horizontal") != std::string::npos;
      for (const float index : indices) {
        ASSERT_EQ (labelled[std::size_t (index)].label, name[8] - '0') << name;
        ASSERT_EQ (index < points_of_plane, is_floor) << name;
      }
    }
  }
  EXPECT_EQ (loaded<InputCloud> ("rest.pcd").sensor_origin_,
             floorAndWall().sensor_origin_);
  expectDone ("in.pcd --rest rest.pcd --quiet");
  EXPECT_TRUE (contains (contentOf (folder_ / "rest.pcd"), "\nPOINTS 0\n"));
}

TEST_F (SegmentParts, PlanesOfAnEarlierRunAreGoneAndOtherFilesStay)
{
  fs::create_directory (folder_ / "planes");
  for (const char* name : {"plane_017_other.pcd", "plane_of_mine.pcd", "notes.txt"})
    folder_.write (std::string ("planes/") + name, "precious");
  expectDone ("scene.pcd planes/all.pcd --planes-dir planes --only horizontal");
  EXPECT_EQ (
      namesIn ("planes"),
      (Names{"all.pcd", "notes.txt", "plane_001_horizontal.pcd", "plane_of_mine.pcd"}));
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
  EXPECT_EQ (namesIn ("planes"), Names{"plane_017_other.pcd"});
  ::close (other_run);
  expectDone ("scene.pcd --planes-dir planes --quiet");
  EXPECT_FALSE (fs::exists (folder_ / "planes/plane_017_other.pcd"));
}

TEST_F (SegmentParts, AFolderWithTheNameOfAPlaneChangesNothing)
{
  expectDone ("scene.pcd --planes-dir planes --quiet");
  const Names names = namesIn ("planes");
  ASSERT_EQ (names.size(), 2u);
  // Whichever comes first: one of them is in the way of the other.
  for (const std::string& in_the_way : names) {
    for (const std::string& name : names) {
      fs::remove_all (folder_ / ("planes/" + name));
      folder_.write ("planes/" + name, "precious");
    }
    fs::remove (folder_ / ("planes/" + in_the_way));
    fs::create_directory (folder_ / ("planes/" + in_the_way));
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
      jsonOf ("scene.pcd labelled.pcd --only vertical --rest rest.pcd")["planes"];
  ASSERT_EQ (planes.size(), 1u);
  EXPECT_EQ (planes[0]["orientation"], "vertical");
  EXPECT_EQ (planes[0]["id"], 1) << "numbered as the labels are";
  const std::vector<std::uint32_t> labels = labelsOf (loaded ("labelled.pcd"));
  EXPECT_EQ (distinct (labels, 0, missing_reading + 1), std::set<std::uint32_t>{0});
  EXPECT_EQ (distinct (labels, missing_reading + 1, air), std::set<std::uint32_t>{1});
  EXPECT_EQ (indicesIn ("rest.pcd").size(), std::size_t (points_of_plane + 3));
}

} // namespace
