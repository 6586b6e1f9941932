// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <io/las_file.h>
#include <numbers/random.h>
#include <support/answers.h>
#include <support/cloud_values.h>
#include <support/las_bytes.h>

#include <cmath>
#include <fstream>
#include <iomanip>
#include <map>

namespace {

using namespace pcl_ops;
using apps::LasPoint;

const Eigen::Vector3d far_away (691'000, 5'334'000, 519);

/** \brief A wall along x, 20 m long, 3 m high and 5 cm thick, in millimeters. */
std::vector<LasPoint>
wall ()
{
  std::vector<LasPoint> points;
  apps::Random random (42);
  const auto drawBelow = [&] (int limit) { return int (limit * random.unit()); };
  for (int i = 0; i < 2000; ++i)
    points.push_back ({{10 * i, drawBelow (50) - 25, drawBelow (3'000)}});
  return points;
}

/** \brief Saves points in millimeters as a LAS.
 * \param[in] offset of all coordinates [m] */
void
save (const std::string& file,
      const std::vector<LasPoint>& points,
      const Eigen::Vector3d& offset = far_away)
{
  constexpr double millimeter = 0.001;
  apps::saveLas (file, points, millimeter, offset);
}

/** \brief Saves the same wall, but from x = 20 m on, as a LAS with other raw numbers:
 * in centimeters, and with an offset 5 km farther along x and -y. */
void
saveEast (const std::string& file)
{
  std::vector<LasPoint> east = wall();
  for (LasPoint& point : east)
    point.raw = {
        point.raw[0] / 10 - 498'000, point.raw[1] / 10 + 500'000, point.raw[2] / 10};
  apps::saveLas (file, east, 0.01, far_away + Eigen::Vector3d (5000, -5000, 0));
}

/** \brief A level square of 50 x 50 points in text.
 * \param[in] distance of neighboring points [m] */
std::string
squareOfPoints (double distance)
{
  std::ostringstream text;
  for (int i = 0; i < 2500; ++i)
    text << distance * (i % 50) << ' ' << distance * (i / 50) << " 0\n";
  return text.str();
}

/** \brief A roof of 100 m x 28 m in text, 20 m high, with a slope of 45 degrees.
 * Heights scatter by up to 3 cm. Its ridge is turned by 30 degrees, whose sine is 0.5.
 */
std::string
steepRoof ()
{
  apps::Random random (3);
  std::ostringstream text;
  text << std::fixed << std::setprecision (3);
  const Eigen::Vector2d along (0.866, 0.5);
  const Eigen::Vector2d upwards (-0.5, 0.866);
  for (int i = 0; i < 60'000; ++i) {
    const double height = 20.0 * random.unit();
    const Eigen::Vector2d position = 100.0 * random.unit() * along + height * upwards;
    text << 691'000 + position.x() << ' ' << 5'334'000 + position.y() << ' '
         << height + 0.03 * random.unit() << '\n';
  }
  return text.str();
}

/** \brief 20,000 points at one place. */
std::string
pointsAtOnePlace ()
{
  std::string text;
  for (int i = 0; i < 20'000; ++i)
    text += "1 1 0\n";
  return text;
}

/** \brief A folder with the files of answers.tsv. */
class TilesAnswers : public AnswersFolder {
protected:
  TilesAnswers() : AnswersFolder (PCL_OPS_TILES_PROGRAM)
  {
    namespace fs = std::filesystem;
    const fs::path answers = PCL_OPS_ANSWERS;
    fs::copy (answers.parent_path() / "outlines.json", folder_.path());
    const std::vector<LasPoint> all = wall();
    save (folder_ / "wall.las", all);
    saveEast (folder_ / "east.las");
    save (folder_ / "zero.las", {});
    save (folder_ / "yonder.las", all, {0, 1e12, 0});
    save (folder_ / "one.las", {all.begin(), all.end() - 600});
    save (folder_ / "two.las", {all.begin() + 600, all.end()});
    for (const auto& [name, unit] :
         {std::pair ("feet.las", unit_foot), std::pair ("meters.las", unit_meter)}) {
      LasRecipe recipe;
      recipe.vlrs = {geoKeys ({{linear_unit, unit}})};
      folder_.write (name, lasBytes (recipe));
    }
    folder_.write ("floor.xyz", squareOfPoints (0.1));
    folder_.write ("one_place.xyz", pointsAtOnePlace());
    folder_.write ("stray.xyz", "1 1e300 1\nnan 1 1\n" + squareOfPoints (0.04));
    folder_.write ("roof.xyz", steepRoof());
    if (!apps::hasLaszip())
      return;
    std::ofstream stream (folder_ / "wall.laz", std::ios::binary);
    apps::compressLas (folder_ / "wall.las", stream);
  }
};

/** \brief A plan whose tiles have a wrong number of cells along an edge. */
class WrongPlan : public ProgramFolder,
                  public testing::WithParamInterface<std::int64_t> {
protected:
  WrongPlan() : ProgramFolder (PCL_OPS_TILES_PROGRAM)
  {
    save (folder_ / "wall.las", wall());
  }
};

/** \brief The finished run of a town of four files, a copy of its folder as "before",
 * and the number of its planes. Tests choose some of the planes. */
class ChosenPlanes : public ProgramFolder {
protected:
  ChosenPlanes() : ProgramFolder (PCL_OPS_TILES_PROGRAM)
  {
    shell ("pcl_ops_simulate town --scene town --points 60000 --tiles 4");
    said_ = expectDone ("town --output-dir out --tile 30").out;
    shell ("cp -r out before");
    const nlohmann::json list =
        nlohmann::json::parse (contentOf (folder_ / "out/planes.json"));
    planes_ = list.at ("planes").size();
  }

  /** \brief Fails if a request to a finished run has changed the files of the run. */
  void
  expectRunUnchanged () const
  {
    const Outcome done = shell ("diff -r before out");
    EXPECT_EQ (done.exit_code, 0) << done.out;
  }

  std::string said_;
  std::size_t planes_ = 0;
};

/** \brief The planes and labels of a town, found in one tile and in many. */
class TownInTiles : public ProgramFolder {
protected:
  using Json = nlohmann::json;
  using Labels = std::vector<std::uint32_t>;

  TownInTiles() : ProgramFolder (PCL_OPS_TILES_PROGRAM)
  {
    shell ("pcl_ops_simulate town --scene town --points 200000 --tiles 1");
    expectDone ("town --output-dir one --cell 1 --tile 100000");
    expectDone ("town --output-dir many --cell 1 --tile 24");
  }

  Json
  planesIn (const std::string& folder) const
  {
    return Json::parse (contentOf (folder_ / (folder + "/planes.json"))).at ("planes");
  }

  Labels
  labelsIn (const std::string& folder) const
  {
    const std::string file = folder_ / (folder + "/town_000_000.las");
    const std::vector<double> values = valuesOf (apps::loadCloud (file), "label");
    return {values.begin(), values.end()};
  }
};

Eigen::Vector3d
vectorOf (const nlohmann::json& plane, const char* key)
{
  const auto numbers = plane.at (key).get<std::vector<double>>();
  return Eigen::Map<const Eigen::Vector3d> (numbers.data());
}

/** \brief The plane of another labeling that shares most points with a plane, and the
 * number of shared points. Label 0: no plane shares a point. */
struct Partner {
  std::uint32_t label = 0;
  std::size_t shared = 0;
};

Partner
partnerOf (std::uint32_t label,
           const std::vector<std::uint32_t>& labels,
           const std::vector<std::uint32_t>& others)
{
  std::map<std::uint32_t, std::size_t> shared;
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (labels[i] == label && others[i] != 0)
      ++shared[others[i]];
  Partner partner;
  for (const auto& [other, points] : shared)
    if (points > partner.shared)
      partner = {other, points};
  return partner;
}

INSTANTIATE_TEST_SUITE_P (All,
                          TilesAnswers,
                          testing::ValuesIn (answersIn (PCL_OPS_ANSWERS)),
                          nameOfAnswers);

} // namespace

TEST_P (TilesAnswers, AreThoseOfTheTable)
{
  expectAnswers ({{"with LASzip:", apps::hasLaszip()}});
}

TEST_F (TownInTiles, EachLargePlaneIsTheSameWithinAPercentAndAMillimeter)
{
  // What src/doc/accuracy.md says of planes of 50 voxels, of some 20 points each.
  constexpr std::size_t min_points = 50 * 20;
  constexpr double min_overlap = 0.99;
  constexpr double max_turn = 0.05 * M_PI / 180.0;
  constexpr double max_offset = 0.001; // [m]
  const Json planes = planesIn ("one");
  const Json others = planesIn ("many");
  const Labels labels = labelsIn ("one");
  const Labels other_labels = labelsIn ("many");
  std::size_t large_planes = 0;
  for (std::uint32_t label = 1; label <= planes.size(); ++label) {
    SCOPED_TRACE ("plane " + std::to_string (label));
    const Json& plane = planes[label - 1];
    const auto points = plane.at ("points").get<std::size_t>();
    if (points < min_points)
      continue;
    ++large_planes;
    const Partner partner = partnerOf (label, labels, other_labels);
    ASSERT_GT (partner.label, 0u);
    const Json& other = others[partner.label - 1];
    const std::size_t in_either =
        points + other.at ("points").get<std::size_t>() - partner.shared;
    EXPECT_GE (double (partner.shared) / double (in_either), min_overlap);
    const Eigen::Vector3d normal = vectorOf (other, "normal");
    EXPECT_LE (vectorOf (plane, "normal").cross (normal).norm(), std::sin (max_turn));
    const Eigen::Vector3d between =
        vectorOf (plane, "centroid") - vectorOf (other, "centroid");
    EXPECT_LE (std::abs (normal.dot (between)), max_offset);
  }
  EXPECT_GT (large_planes, 10u);
}

// Along its edge, a tile must have a multiple of four cells, 12 or more, and not too
// many.
INSTANTIATE_TEST_SUITE_P (CellsAlongATile,
                          WrongPlan,
                          testing::Values (0, -40, 13, 4'000'000'000));

TEST_P (WrongPlan, IsRefused)
{
  expectDone ("wall.las --output-dir out --cell 0.5 --plan plan.json");
  nlohmann::json plan = nlohmann::json::parse (contentOf (folder_ / "plan.json"));
  ASSERT_TRUE (plan.contains ("cells_of_tile"));
  plan["cells_of_tile"] = GetParam();
  folder_.write ("wrong.json", plan.dump());
  const Outcome done =
      shell ("pcl_ops_tiles wall.las --output-dir other --plan wrong.json");
  EXPECT_EQ (done.exit_code, 1);
  EXPECT_EQ (done.err, "pcl_ops_tiles: wrong.json: is no plan; give another --plan\n");
}

TEST_F (ChosenPlanes, AllAreCountedByTheRun)
{
  EXPECT_TRUE (
      contains (said_, "planes.json, " + std::to_string (planes_) + " planes\n"));
}

TEST_F (ChosenPlanes, OfASlopeAndAnAreaAreRoofsWithFewCornersFacingUp)
{
  expectDone ("town --output-dir out --quiet --planes roofs.geojson --slope 5,80 "
              "--min-area 20 --simplify 0.5 --crs EPSG:25832");
  const nlohmann::json roofs =
      nlohmann::json::parse (contentOf (folder_ / "roofs.geojson"));
  EXPECT_EQ (roofs["crs"]["properties"]["name"], "urn:ogc:def:crs:EPSG::25832");
  EXPECT_GE (roofs["features"].size(), 2u);
  for (const nlohmann::json& roof : roofs["features"]) {
    const nlohmann::json& properties = roof.at ("properties");
    SCOPED_TRACE (properties.at ("id"));
    EXPECT_EQ (properties.at ("orientation"), "other");
    EXPECT_GE (properties.at ("area").get<double>(), 20.0);
    EXPECT_GT (properties.at ("nz").get<double>(), 0.0);
    constexpr std::size_t few_corners = 12; // the first comes again as the last
    EXPECT_LE (roof.at ("geometry").at ("coordinates").at (0).size(), few_corners + 1);
  }
  expectRunUnchanged();
}

TEST_F (ChosenPlanes, AreAsManyInACsvAsInAGeojson)
{
  const std::string choice =
      "town --output-dir out --quiet --only other --min-area 20 ";
  expectDone (choice + "--planes others.csv");
  expectDone (choice + "--planes others.geojson");
  const std::size_t header = 1;
  EXPECT_GT (lines (contentOf (folder_ / "others.csv")), 1 + header);
  EXPECT_EQ (nlohmann::json::parse (contentOf (folder_ / "others.geojson"))["features"]
                     .size() +
                 header,
             lines (contentOf (folder_ / "others.csv")));
}

TEST_F (ChosenPlanes, AreCountedBesideAllAndDrawn)
{
  const std::string said =
      expectDone ("town --output-dir out --planes p.csv --image p.png --max-planes 2")
          .out;
  EXPECT_TRUE (contains (
      said, " " + std::to_string (planes_) + " planes; p.csv: 2 planes, dropped "));
  EXPECT_TRUE (contains (contentOf (folder_ / "p.png"), "PNG\r\n"));
  EXPECT_EQ (lines (contentOf (folder_ / "p.csv")), 1u + 2u) << "a header, two planes";
}
