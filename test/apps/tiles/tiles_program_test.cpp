// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <io/las_file.h>
#include <numbers/random.h>
#include <support/answers.h>
#include <support/cloud_values.h>

#include <cmath>
#include <fstream>
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
  const auto below = [&] (int length) { return int (length * random.unit()); };
  for (int i = 0; i < 2000; ++i)
    points.push_back ({{10 * i, below (50) - 25, below (3'000)}});
  return points;
}

void
save (const std::string& file,
      const std::vector<LasPoint>& points,
      const Eigen::Vector3d& place = far_away)
{
  apps::saveLas (file, points, 0.001, place);
}

/** \brief The same wall from 20 m on, in centimeters, with an offset 5 km farther. */
void
saveEast (const std::string& file)
{
  std::vector<LasPoint> east = wall();
  for (LasPoint& point : east)
    point.raw = {
        point.raw[0] / 10 - 498'000, point.raw[1] / 10 + 500'000, point.raw[2] / 10};
  apps::saveLas (file, east, 0.01, far_away + Eigen::Vector3d (5000, -5000, 0));
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
    if (!apps::hasLaszip())
      return;
    std::ofstream stream (folder_ / "wall.laz", std::ios::binary);
    apps::compressLas (folder_ / "wall.las", stream);
  }
};

/** \brief A town found in one tile and in many. */
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

/** \brief The plane of another labeling that has most points of one, and how many. */
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

// What src/doc/tiles.md promises of planes of 50 cells and more.
TEST_F (TownInTiles, EachLargePlaneIsTheSameWithinAPercentAndAMillimeter)
{
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
