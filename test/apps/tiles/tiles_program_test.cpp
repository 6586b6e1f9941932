// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <io/las_file.h>
#include <numbers/random.h>
#include <support/answers.h>

#include <fstream>

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

INSTANTIATE_TEST_SUITE_P (All,
                          TilesAnswers,
                          testing::ValuesIn (answersIn (PCL_OPS_ANSWERS)),
                          nameOfAnswers);

} // namespace

TEST_P (TilesAnswers, AreThoseOfTheTable)
{
  expectAnswers ({{"with LASzip:", apps::hasLaszip()}});
}
