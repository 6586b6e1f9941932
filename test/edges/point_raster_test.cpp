// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "edges/point_raster.h"
#include "scene.h"

using pcl_ops::PlanarPoints;
using pcl_ops::internal::PlanarLine;
using pcl_ops::internal::PointRaster;

namespace {

PlanarPoints
scattered (int number, double width, double height)
{
  RandomGenerator generator (seedOfTest());
  PlanarPoints points;
  for (int i = 0; i < number; ++i) {
    const double x = width * drawUnit (generator);
    points.emplace_back (x, height * drawUnit (generator));
  }
  return points;
}

std::vector<double>
bruteForce (const PlanarPoints& points, const PlanarLine& line, double reach)
{
  std::vector<double> places;
  for (const Eigen::Vector2d& point : points)
    if (std::abs (line.distance (point)) <= reach)
      places.push_back (line.direction.dot (point - line.origin));
  std::sort (places.begin(), places.end());
  return places;
}

void
expectAsBruteForce (const PlanarPoints& points)
{
  const PointRaster raster (points);
  for (int degree = 0; degree < 360; degree += 15)
    for (const double offset : {-3.0, 0.0, 0.4}) {
      const double angle = degree * 1_deg;
      const Eigen::Vector2d direction (std::cos (angle), std::sin (angle));
      const PlanarLine line{{1.0, offset}, direction};
      std::vector<double> places = raster.placesBeside (line, 5_cm);
      std::sort (places.begin(), places.end());
      EXPECT_EQ (places, bruteForce (points, line, 5_cm)) << degree << " " << offset;
    }
}

} // namespace

TEST (PointRaster, FindsWhatBruteForceFinds)
{
  expectAsBruteForce (scattered (3000, 2_m, 1_m));
}

TEST (PointRaster, FindsItInLongAndThinPlanes)
{
  expectAsBruteForce (scattered (1000, 100_m, 1_cm));
  expectAsBruteForce (scattered (1000, 1_cm, 100_m));
}

TEST (PointRaster, FindsItWherePointsSpanNoArea)
{
  expectAsBruteForce ({});
  expectAsBruteForce (PlanarPoints (100, Eigen::Vector2d (1.0, 0.41)));
  expectAsBruteForce (scattered (100, 2_m, 0.0));
}

TEST (PointRaster, LeavesOutWhatIsNotFinite)
{
  PlanarPoints points = scattered (100, 2_m, 1_m);
  const std::size_t finite =
      PointRaster (points).placesBeside ({{0, 0}, {1, 0}}, 10_m).size();
  points.emplace_back (std::numeric_limits<double>::quiet_NaN(), 0.0);
  points.emplace_back (0.0, std::numeric_limits<double>::infinity());
  EXPECT_EQ (PointRaster (points).placesBeside ({{0, 0}, {1, 0}}, 10_m).size(), finite);
}
