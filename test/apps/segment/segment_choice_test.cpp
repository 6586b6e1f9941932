// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "segment_program.h"

#include <tuple>

namespace {

/** \brief The program with floor.pcd: a floor of 2 m by 2 m, and a board of 0.3 m by
 * 1 m that leans by 30 degrees, two metres above. */
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
    LabelledCloud cloud;
    EXPECT_EQ (pcl::io::loadPCDFile (folder_ / "labelled.pcd", cloud), 0);
    const bool is_floor = points == points_of_plane;
    EXPECT_EQ (cloud.front().label, is_floor ? 1u : 0u) << options;
    EXPECT_EQ (cloud.back().label, is_floor ? 0u : 1u) << options;
    return json;
  }

  static constexpr int points_of_board = 1500;
};

} // namespace

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
