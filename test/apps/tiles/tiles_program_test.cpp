// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tiles_program.h"
#include <io/laz_file.h>
#include <numbers/random.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>
#include <tuple>

namespace fs = std::filesystem;

namespace {

using namespace pcl_ops;
using apps::LasPoint;

const Eigen::Vector3d far_away (691'000, 5'334'000, 519);

/** \brief A wall along x from 0, 20 m long, 3 m high, with 1.5 cm of noise, in
 * millimeters. */
std::vector<LasPoint>
wall ()
{
  std::vector<LasPoint> points;
  apps::Random random (42);
  const auto millimeters = [] (double meters) {
    return static_cast<std::int32_t> (std::lround (1000.0 * meters));
  };
  for (int i = 0; i < 2000; ++i) {
    const double x = 20.0 * random.unit();
    const double z = 3.0 * random.unit();
    double noise = -0.09;
    for (int k = 0; k < 12; ++k)
      noise += 0.015 * random.unit();
    points.push_back ({{millimeters (x), millimeters (noise), millimeters (z)}, 0});
  }
  return points;
}

class TilesProgram : public Tiles {
protected:
  void
  save (const std::string& name, const std::vector<LasPoint>& points) const
  {
    apps::saveLas (folder_ / name, points, 0.001, far_away);
  }
};

} // namespace

TEST_F (TilesProgram, TakesALazForALas)
{
  if (!apps::hasLaszip())
    GTEST_SKIP() << "LASzip is missing";
  save ("wall.las", wall());
  fs::create_directory (folder_ / "packed");
  {
    std::ofstream stream (folder_ / "packed/wall.laz", std::ios::binary);
    apps::compressLas (folder_ / "wall.las", stream);
  }
  expectDone ("wall.las --output-dir plain --cell 0.5 --tile 10");
  expectDone ("packed --output-dir out --cell 0.5 --tile 10");
  {
    std::ofstream stream (folder_ / "out/wall.las", std::ios::binary);
    apps::decompressLaz (folder_ / "out/wall.laz", stream);
  }
  EXPECT_TRUE (contentOf (folder_ / "out/wall.las") ==
               contentOf (folder_ / "plain/wall.las"));
}

TEST_F (TilesProgram, IsPclOpsSegmentWhereThereIsOneTile)
{
  makeTown ("--points 60000 --tiles 1");
  expectDone ("town --output-dir out --cell 1.2 --tile 100000");
  ASSERT_EQ (listIn ("out").at ("tiles"), 1);
  const Outcome segmented =
      shell ("'" PCL_OPS_SEGMENT_PROGRAM "' town/town_000_000.las one.las --cell 1.2");
  ASSERT_EQ (segmented.exit_code, 0) << segmented.err;
  EXPECT_EQ (contentOf (folder_ / "out/town_000_000.las"),
             contentOf (folder_ / "one.las"));
  const std::vector<std::uint32_t> labels = labelsIn ("one.las");
  EXPECT_GT (std::set<std::uint32_t> (labels.begin(), labels.end()).size(), 5u);
}

TEST_F (TilesProgram, FindsInManyTilesThePlanesOfOne)
{
  constexpr double min_points = 50 * 20; // 50 cells and more
  makeTown ("--points 200000 --tiles 1");
  expectDone ("town --output-dir one --cell 1 --tile 100000");
  expectDone ("town --output-dir many --cell 1 --tile 24");
  const nlohmann::json one = listIn ("one"), many = listIn ("many");
  ASSERT_GT (many.at ("tiles"), 9);
  const std::vector<std::uint32_t> in_one = labelsIn ("one/town_000_000.las"),
                                   in_many = labelsIn ("many/town_000_000.las");
  std::map<std::pair<std::uint32_t, std::uint32_t>, double> counts;
  for (std::size_t i = 0; i < in_one.size(); ++i)
    ++counts[{in_one[i], in_many[i]}];
  std::size_t large = 0;
  for (std::uint32_t p = 1; p <= one.at ("planes").size(); ++p) {
    SCOPED_TRACE (p);
    const nlohmann::json& plane = one.at ("planes").at (p - 1);
    if (plane.at ("points") < min_points)
      continue;
    ++large;
    std::pair<double, std::uint32_t> match; // points shared, label
    for (const auto& [labels, count] : counts)
      if (labels.first == p && labels.second > 0)
        match = std::max (match, {count, labels.second});
    ASSERT_GT (match.second, 0u);
    const nlohmann::json& other = many.at ("planes").at (match.second - 1);
    const double sum =
        plane.at ("points").get<double>() + other.at ("points").get<double>();
    EXPECT_GE (match.first / (sum - match.first), 0.99);
    const Eigen::Vector3d normal = toVector (other["normal"]);
    EXPECT_LE (toVector (plane["normal"]).cross (normal).norm(),
               std::sin (0.05 * M_PI / 180));
    const double offset =
        normal.dot (toVector (plane["centroid"]) - toVector (other["centroid"]));
    EXPECT_LE (std::abs (offset), 0.001);
  }
  EXPECT_GT (large, 10u);
}

TEST_F (TilesProgram, GivesTheSameBytesForAnyNumberOfJobsAndOrderOfInputs)
{
  makeTown();
  const std::string planes = " --planes planes.geojson";
  expectDone ("town --output-dir one --tile 30" + planes);
  const std::string map = contentOf (folder_ / "planes.geojson");
  const auto expected = outputsIn ("one");
  ASSERT_EQ (expected.size(), 5u);
  for (const char* inputs : {"town --jobs 2",
                             "town --jobs 3",
                             "town/town_001_001.las town/town_000_000.las "
                             "town/town_001_000.las town/town_000_001.las"}) {
    fs::remove_all (folder_ / "other");
    expectDone (inputs + std::string (" --output-dir other --tile 30") + planes);
    EXPECT_EQ (outputsIn ("other"), expected) << inputs;
    EXPECT_EQ (contentOf (folder_ / "planes.geojson"), map) << inputs;
  }
}

TEST_F (TilesProgram, LabelsPcdAndPlyWithColors)
{
  makeTown ("--points 20000 --tiles 1");
  shell ("'" PCL_OPS_SEGMENT_PROGRAM "' town/town_000_000.las a.pcd");
  expectDone ("a.pcd --output-dir out");
  const apps::FileCloud cloud = apps::loadCloud (folder_ / "out/a.pcd");
  EXPECT_EQ (fieldOf (cloud, "rgb").name, "rgb");
  const std::vector<std::uint32_t> labels = labelsIn ("out/a.pcd");
  EXPECT_GT (*std::max_element (labels.begin(), labels.end()), 3u);
}

TEST_F (TilesProgram, JoinsAWallOfTilesWithTheirOwnScaleAndOffset)
{
  const std::vector<LasPoint> west = wall();
  std::vector<LasPoint> east = west;
  // In centimeters, from 5 km farther.
  const Eigen::Vector3d farther = far_away + Eigen::Vector3d (5000.0, -5000.0, 0.0);
  for (LasPoint& point : east) {
    point.raw[0] += 20'000;
    for (int axis = 0; axis < 3; ++axis)
      point.raw[axis] = static_cast<std::int32_t> (
          std::lround (0.1 * point.raw[axis] - 100.0 * (farther - far_away)[axis]));
  }
  save ("west.las", west);
  apps::saveLas (folder_ / "east.las", east, 0.01, farther);
  expectDone ("west.las east.las --output-dir out --cell 0.5 --tile 10");
  const nlohmann::json list = listIn ("out"), planes = list.at ("planes");
  ASSERT_EQ (planes.size(), 1u);
  EXPECT_GE (list.at ("tiles"), 4);
  EXPECT_EQ (planes.at (0).at ("tiles").size(), list.at ("tiles"));
  EXPECT_EQ (planes.at (0).at ("points"), west.size() + east.size());
  EXPECT_NEAR (toVector (planes.at (0)["centroid"]).y(), far_away.y(), 0.01);
  EXPECT_NEAR (planes.at (0).at ("extent").at ("length"), 40.0, 0.5);
  EXPECT_NEAR (toVector (planes.at (0)["centroid"]).x(), far_away.x() + 20.0, 0.1);
}

TEST_F (TilesProgram, LabelsInputsThatOverlapEachWithAllItsPoints)
{
  const std::vector<LasPoint> all = wall();
  save ("one.las", {all.begin(), all.end() - 600});
  save ("two.las", {all.begin() + 600, all.end()});
  expectDone ("one.las two.las --output-dir out --cell 0.5 --tile 10");
  const nlohmann::json list = listIn ("out");
  ASSERT_EQ (list.at ("planes").size(), 1u);
  EXPECT_EQ (list.at ("points"), 2800);
  EXPECT_EQ (list.at ("planes").at (0).at ("points"), 2800);
  for (const char* name : {"out/one.las", "out/two.las"})
    EXPECT_EQ (labelsIn (name), std::vector<std::uint32_t> (1400, 1u));
}

TEST_F (TilesProgram, WritesTheChosenPlanesOfAFinishedRunToo)
{
  makeTown();
  const Outcome whole = run ("town --output-dir out --tile 30");
  const nlohmann::json list = listIn ("out");
  const std::string all = std::to_string (list.at ("planes").size()) + " planes";
  EXPECT_TRUE (contains (whole.out, "planes.json, " + all + "\n"));
  const auto before = outputsIn ("out");
  expectDone ("town --output-dir out --quiet --planes roofs.geojson --slope 5,80 "
              "--min-area 20 --simplify 0.5 --crs EPSG:25832");
  EXPECT_EQ (outputsIn ("out"), before);
  const auto map = jsonIn ("roofs.geojson");
  EXPECT_EQ (map.at ("crs").at ("properties").at ("name"),
             "urn:ogc:def:crs:EPSG::25832");
  std::size_t roofs = 0;
  for (const auto& plane : list.at ("planes"))
    roofs += plane.at ("orientation") == "other" && plane.at ("area") >= 20.0 ? 1 : 0;
  EXPECT_GE (roofs, 2u);
  ASSERT_EQ (map.at ("features").size(), roofs);
  for (const auto& feature : map.at ("features")) {
    const auto& properties = feature.at ("properties");
    EXPECT_EQ (properties.at ("orientation"), "other");
    EXPECT_GT (properties.at ("nz"), 0.0) << "normals of surveys point up";
    EXPECT_LE (feature.at ("geometry").at ("coordinates").at (0).size(), 12u);
  }
  const Outcome few =
      run ("town --output-dir out --planes p.csv --image p.png --max-planes 2");
  EXPECT_EQ (contentOf (folder_ / "p.png").find ("PNG"), 1u);
  EXPECT_TRUE (contains (few.out, all + "; p.csv: 2 planes, dropped "));
  EXPECT_EQ (lines (contentOf (folder_ / "p.csv")), 3u);
}

TEST_F (TilesProgram, DrawsASteepRoofThroughManyTilesAsOne)
{
  apps::Random random (3);
  std::string text;
  for (int i = 0; i < 60'000; ++i) {
    const double x = 100.0 * random.unit(), y = 20.0 * random.unit();
    const double noise = 0.03 * random.unit();
    // The ridge is turned by 30 degrees.
    text += std::to_string (0.866 * x - 0.5 * y) + " " +
            std::to_string (0.5 * x + 0.866 * y) + " " + std::to_string (y + noise) +
            "\n";
  }
  folder_.write ("roof.xyz", text);
  expectDone ("roof.xyz --output-dir out --cell 0.9 --tile 12");
  const nlohmann::json planes = listIn ("out").at ("planes");
  ASSERT_EQ (planes.size(), 1u);
  EXPECT_NEAR (planes[0].at ("area"), 2000.0 * std::sqrt (2.0), 30.0);
  EXPECT_TRUE (planes[0].at ("holes").empty());
  EXPECT_FALSE (planes[0].contains ("parts"));
  EXPECT_NEAR (planes[0].at ("slope"), 45.0, 0.1);
  EXPECT_NEAR (planes[0].at ("aspect"), 150.0, 0.1) << "down to the south-east";
}

TEST_F (TilesProgram, SaysWhatItWouldDoAndLeavesOutATileWithoutPoints)
{
  makeTown ("--points 2000 --tiles 4");
  save ("town/zero.las", {});
  const Outcome plan = expectDone ("town --output-dir out --tile 30 --dry-run");
  EXPECT_TRUE (contains (plan.out, "points of 4 inputs"));
  EXPECT_FALSE (fs::exists (folder_ / "out"));
  const Outcome done = expectDone ("town --output-dir out");
  EXPECT_EQ (done.err, "pcl_ops_tiles: town/zero.las: has no points; it is left out\n");
  for (const char* damaged : {"", "{}", R"({"planes":[{"id":1}]})"}) {
    folder_.write ("out/planes.json", damaged);
    EXPECT_TRUE (contains (run ("town --output-dir out --planes p.csv").err,
                           "out/planes.json: is no list of planes; remove it and run "
                           "it again\n"));
  }
}

TEST_F (TilesProgram, CountsAFileAndLinksToItOnce)
{
  makeTown ("--points 20000 --tiles 1");
  const fs::path town = folder_ / "town/town_000_000.las";
  fs::create_directory (folder_ / "links");
  fs::create_symlink (town, folder_ / "links/a.las");
  fs::create_hard_link (town, folder_ / "town/z.las");
  expectDone ("town/town_000_000.las --output-dir once");
  for (const char* inputs : {"links town", "town links"}) {
    const Outcome done = expectDone (inputs + std::string (" --output-dir out"));
    EXPECT_EQ (done.err,
               "pcl_ops_tiles: town/z.las: is the same file as town/town_000_000.las; "
               "it is left out\npcl_ops_tiles: links/a.las: is the same file as "
               "town/town_000_000.las; it is left out\n");
    EXPECT_EQ (outputsIn ("out"), outputsIn ("once"));
  }
}

TEST_F (TilesProgram, NamesTheInputThatIsTooFarAwayAndLeavesOutStrayPoints)
{
  save ("wall.las", wall());
  apps::saveLas (folder_ / "yonder.las", wall(), 0.001, Eigen::Vector3d (0, 1e12, 0));
  expectRefused ("wall.las yonder.las --output-dir out --cell 0.5",
                 "--cell: cells of 0.5 reach 5e+08 from zero, and " +
                     (folder_ / "yonder.las") +
                     " has points farther away; give a larger one",
                 2);
  std::string text = "1 1e300 1\n";
  for (const LasPoint& point : wall())
    for (int axis = 0; axis < 3; ++axis)
      text += std::to_string (0.001 * point.raw[axis]) + (axis < 2 ? " " : "\n");
  folder_.write ("stray.xyz", text);
  expectDone ("stray.xyz --output-dir out --cell 0.5");
  EXPECT_EQ (listIn ("out").at ("planes").at (0).at ("points"), wall().size());
}

TEST_F (TilesProgram, AsksToRenameWhatIsNoUtf8)
{
  const std::string latin = "W\xe4nde";
  fs::create_directory (folder_ / latin);
  save ("wall.las", wall());
  save (latin + "/wall.las", wall());
  save (latin + ".las", wall());
  save ("W\xc3\xa4nde.las", wall());
  for (const std::string& subject :
       {latin + ".las: its name", latin + "/wall.las: the name of a folder it is in"}) {
    const std::string file = subject.substr (0, subject.find (':'));
    expectRefused (file + " --output-dir out", subject + " is not UTF-8; rename it");
    EXPECT_FALSE (fs::exists (folder_ / "out/work/plan.json"));
  }
  expectDone ("W\xc3\xa4nde.las --output-dir " + latin + "/out --cell 0.5");
  EXPECT_EQ (listIn (latin + "/out").at ("planes").at (0).at ("inputs").at (0),
             "W\xc3\xa4nde.las");
}

TEST_F (TilesProgram, RefusesAPlanOfAnotherVersionOrWithoutLengths)
{
  makeTown ("--points 2000 --tiles 1");
  expectDone ("town --output-dir out --plan plan.json");
  const nlohmann::json plan = jsonIn ("plan.json");
  nlohmann::json changes = {{{"format", plan["format"].get<int>() - 1}}};
  for (const std::int64_t cells : {0L, -40L, 13L, 4'000'000'000L})
    changes.push_back ({{"cells_of_tile", cells}});
  for (const nlohmann::json& change : changes) {
    nlohmann::json other = plan;
    other.update (change);
    folder_.write ("plan.json", other.dump());
    const std::string problem = change.contains ("format")
                                    ? "is the plan of another version of this program"
                                    : "is no plan";
    expectRefused ("town --output-dir other --plan plan.json",
                   "plan.json: " + problem + "; remove it or give another --plan\n");
  }
}

TEST_F (TilesProgram, RefusesThePlanOfAnotherRunWhateverItIsCalled)
{
  makeTown ("--points 20000 --tiles 1");
  fs::copy (folder_ / "town", folder_ / "more");
  expectDone ("town --output-dir out --plan a.json");
  expectDone ("town --output-dir other --plan b.json --cell 3");
  const auto expected = outputsIn ("out");
  const std::string plan = "out/work/plan.json: is ",
                    fix = "; remove its folder or give another --output-dir\n";
  const std::pair<const char*, std::string> rows[] = {
      {"town --output-dir out --cell 3",
       plan + "the plan of another run (--cell was another one)" + fix},
      {"more --output-dir out --plan c.json --cell 3",
       plan + "the plan of another run (more/town_000_000.las is not in it)" + fix},
      {"town --output-dir out --plan b.json", plan + "another plan than b.json" + fix},
      {"town --output-dir third --plan b.json --cell 2",
       "b.json: is the plan of another run (--cell was another one); remove it or give "
       "another --plan\n"}};
  for (const auto& [arguments, complaint] : rows)
    expectRefused (arguments, complaint);
  EXPECT_EQ (outputsIn ("out"), expected);
  EXPECT_FALSE (fs::exists (folder_ / "c.json"));
  expectDone ("town --output-dir out --plan c.json");
  EXPECT_EQ (contentOf (folder_ / "c.json"), contentOf (folder_ / "a.json"));
}
