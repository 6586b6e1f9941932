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
