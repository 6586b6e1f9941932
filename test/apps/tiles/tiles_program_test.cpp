// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <io/las_file.h>
#include <numbers/random.h>
#include <support/answers.h>

#include <cmath>
#include <fstream>

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
    return std::int32_t (std::lround (1000.0 * meters));
  };
  for (int i = 0; i < 2000; ++i) {
    const double x = 20.0 * random.unit();
    const double z = 3.0 * random.unit();
    double noise = -0.09;
    for (int k = 0; k < 12; ++k)
      noise += 0.015 * random.unit();
    points.push_back ({{millimeters (x), millimeters (noise), millimeters (z)}});
  }
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
  const Eigen::Vector3d farther = far_away + Eigen::Vector3d (5000.0, -5000.0, 0.0);
  std::vector<LasPoint> east = wall();
  for (LasPoint& point : east) {
    point.raw[0] += 20'000;
    for (int axis = 0; axis < 3; ++axis)
      point.raw[axis] =
          std::lround (0.1 * point.raw[axis] - 100.0 * (farther - far_away)[axis]);
  }
  apps::saveLas (file, east, 0.01, farther);
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
