// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/planar_area.h"
#include "planes/planar_ring.h"
#include "scene.h"
#include <pcl_ops/surface/concave_hull.h>
#include <pcl_ops/surface/triangulation.h>

using namespace pcl_ops;
using namespace pcl_ops::internal;

namespace {

const PlaneFrame ground (Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitZ());

/** \brief The outer ring of the concave outline; empty if there is none.
 * \param[in] alpha radius that decides which gaps are outside [m]; 0: by the spacing */
PlanarPoints
concaveHull (const PlanarPoints& points, double alpha = 0.0)
{
  const PlanarRings rings = concaveOutline (points, alpha);
  return rings.empty() ? PlanarPoints() : rings.front();
}

/** \brief Share of the points that are inside the outline or nearer than 1 um to it. */
double
shareInside (const PlanarPoints& points, const PlanarPoints& outline)
{
  const Ring ring (outline.begin(), outline.end());
  const auto inside = std::count_if (points.begin(), points.end(), [&] (const auto& p) {
    return boost::geometry::distance (p, ring) < 1e-6;
  });
  return static_cast<double> (inside) / static_cast<double> (points.size());
}

/** \brief Whether a point is in an L of two bars of 2 m x 0.5 m from zero along x and
 * y; the coordinates are at least 0. Rounding of the ends at 2 m does not matter. */
bool
isInL (const Eigen::Vector2d& point)
{
  return point.maxCoeff() <= 2.0 + 1e-9 && point.minCoeff() <= 0.5;
}

constexpr double area_of_l = 1.75;                 // [m^2]
constexpr double area_of_convex_hull_of_l = 2.875; // [m^2]

/** \brief The points of a grid on a square of 3 m that are in a shape.
 * \param[in] steps number of steps of the grid along each edge of the square */
template <typename Shape>
PlanarPoints
gridOf (int steps, Shape&& isInShape)
{
  PlanarPoints grid;
  for (int x = 0; x <= steps; ++x)
    for (int y = 0; y <= steps; ++y)
      if (const Eigen::Vector2d point = 3.0 / steps * Eigen::Vector2d (x, y);
          isInShape (point))
        grid.push_back (point);
  return grid;
}

/** \brief Whether a point is in a wall of 3 m x 2.5 m with a window of 1 m x 0.8 m.
 * Points on the rims are in it, also those moved a little by rounding. */
bool
isInWall (const Eigen::Vector2d& point)
{
  const bool is_in_window =
      point.x() > 1.001 && point.x() < 1.999 && point.y() > 1.001 && point.y() < 1.799;
  return point.y() < 2.501 && !is_in_window;
}

constexpr double area_with_window = 3_m * 2.5_m;
constexpr double area_of_window = 1_m * 0.8_m;

/** \brief Draws points in a square of 3 m until a number of them are in a shape.
 * \param[in] noise standard deviation of both coordinates [m] */
template <typename Shape>
PlanarPoints
scattered (std::size_t number, double noise, Shape&& isInShape)
{
  RandomGenerator generator (seedOfTest());
  PlanarPoints points;
  while (points.size() < number) {
    const double x = 3.0 * drawUnit (generator);
    const double y = 3.0 * drawUnit (generator);
    if (isInShape ({x, y}))
      points.emplace_back (x + noise * drawGaussian (generator),
                           y + noise * drawGaussian (generator));
  }
  return points;
}

} // namespace

TEST (ConcaveHull, FollowsAnLWhereTheConvexHullDoesNot)
{
  const PlanarPoints l = gridOf (300, isInL);
  EXPECT_NEAR (areaOf (convexHull (l)), area_of_convex_hull_of_l, 1e-6);
  EXPECT_NEAR (areaOf (concaveHull (l)) / area_of_l, 1.0, 1_percent);
  constexpr double large_alpha = 100.0; // [m]
  EXPECT_NEAR (areaOf (concaveHull (l, large_alpha)), area_of_convex_hull_of_l, 0.01);
}

TEST (ConcaveHull, HasTheAreaOfScatteredPointsAndNearlyAllInsideTheSameEveryTime)
{
  for (const std::size_t points : {3000, 30000, 100000})
    for (const double noise : {0.0, 5_mm}) {
      const PlanarPoints l = scattered (points, noise, isInL);
      const PlanarPoints hull = concaveHull (l);
      EXPECT_NEAR (areaOf (hull) / area_of_l, 1.0, 5_percent)
          << points << ", " << noise << " m of noise";
      EXPECT_GE (shareInside (l, hull), 99_percent) << points;
      EXPECT_TRUE (boost::geometry::is_valid (Ring (hull.begin(), hull.end())))
          << "crosses itself";
      EXPECT_EQ (concaveHull (l), hull);
    }
}

TEST (ConcaveHull, IsTheSameForAnyOrderOfThePoints)
{
  for (std::size_t number = 100; number <= 2000; number += 100) {
    PlanarPoints l = scattered (number, 5_cm, isInL);
    const PlanarPoints hull = concaveHull (l);
    std::reverse (l.begin(), l.end());
    EXPECT_EQ (concaveHull (l), hull) << number;
  }
}

TEST (ConcaveHull, OfAnAlphaBelowAllDistancesIsTheConvexOne)
{
  // In all eight attempts the radius is below that of any triangle.
  const PlanarPoints l = gridOf (30, isInL);
  EXPECT_NEAR (areaOf (concaveHull (l, 1e-19)), areaOf (convexHull (l)), 1e-9);
}

TEST (ConcaveHull, GoesAroundAllPartsOfAPlane)
{
  PlanarPoints parts = gridOf (300, isInL);
  for (const Eigen::Vector2d& point : gridOf (300, isInL))
    parts.emplace_back (point + Eigen::Vector2d (3.0, 0.0));
  EXPECT_GE (shareInside (parts, concaveHull (parts)), 99_percent);
}

TEST (ConcaveHull, OfPointsThatSpanNoAreaIsEmptyAndOfThreeTheirTriangle)
{
  PlanarPoints line;
  for (int i = 0; i < 1000; ++i)
    line.emplace_back (0.1 * i, 0.2 * i);
  for (const PlanarPoints& points :
       {PlanarPoints{}, {{1, 2}, {3, 4}}, line, PlanarPoints (1000, {1, 2})})
    EXPECT_TRUE (concaveHull (points).empty());
  EXPECT_NEAR (areaOf (concaveHull ({{0, 0}, {1, 0}, {0, 1}})), 0.5, 1e-9);
}

TEST (ConcaveOutline, HasTheWindowOfAWallAsAHoleAndTakesItOffTheArea)
{
  const PlanarPoints wall = gridOf (150, isInWall);
  const PlanarRings outline = concaveOutline (wall);
  ASSERT_EQ (outline.size(), 2u);
  EXPECT_NEAR (areaOf (outline[0]), area_with_window, 1_percent * area_with_window);
  EXPECT_NEAR (areaOf (outline[1]), -area_of_window, 5_percent) << "clockwise";
  for (const Eigen::Vector2d& corner : outline[1]) {
    EXPECT_NEAR (corner.x(), 1.5, 0.5 + 1e-9);
    EXPECT_NEAR (corner.y(), 1.4, 0.4 + 1e-9);
  }
  const PlaneExtent extent = extentOf (outline, wall, ground);
  EXPECT_NEAR (
      extent.area, area_with_window - area_of_window, 1_percent * area_with_window);
  ASSERT_EQ (extent.holes.size(), 1u);
  ASSERT_EQ (extent.rings().size(), 2u);
  EXPECT_EQ (extent.rings()[0], extent.hull);
  EXPECT_NEAR (extent.length, 3.0, 1e-6) << "of the outer ring";
}

TEST (ConcaveOutline, HasTheWindowOfScatteredNoisyPointsAndOfAFullSurfaceNoHole)
{
  const PlanarRings outline = concaveOutline (scattered (30000, 5_mm, isInWall));
  ASSERT_EQ (outline.size(), 2u);
  EXPECT_NEAR (areaOf (outline[1]), -area_of_window, 10_percent);
  EXPECT_EQ (concaveOutline (gridOf (300, isInL)).size(), 1u);
  EXPECT_EQ (concaveOutline (scattered (30000, 5_mm, isInL)).size(), 1u);
}

TEST (ConcaveOutline, HasNoHolesThatAreNextToNothing)
{
  // The circle through the first three points has a radius of 1.001, above alpha, and
  // no point in it: by alpha alone their triangle, 2 m long and 0.2 m wide, would be a
  // hole. All other circles through three points that have no point in them are
  // smaller.
  PlanarPoints points = {{-0.9985, 0.1}, {-0.9985, -0.1}, {0.9985, 0.0}};
  for (const double sign : {1.0, -1.0}) {
    points.emplace_back (0.0, sign * 1.05);
    for (const Eigen::Vector2d& corner : {Eigen::Vector2d (1.0, 1.0), {1.9, 0.5}}) {
      points.emplace_back (corner.x(), sign * corner.y());
      points.emplace_back (-corner.x(), sign * corner.y());
    }
  }
  constexpr double alpha = 1.0;
  EXPECT_EQ (concaveOutline (points, alpha).size(), 1u);
}

TEST (ConcaveOutline, OfAWallOfAnySizeIsTheSame)
{
  const PlanarRings expected = concaveOutline (gridOf (150, isInWall));
  for (const double size : {1e-40, 1e-9, 1e-6, 1e-3, 1e6}) {
    PlanarPoints wall = gridOf (150, isInWall);
    for (Eigen::Vector2d& point : wall)
      point *= size;
    const PlanarRings outline = concaveOutline (wall);
    ASSERT_EQ (outline.size(), 2u) << size;
    for (const std::size_t ring : {0, 1})
      EXPECT_NEAR (
          areaOf (outline[ring]) / (size * size), areaOf (expected[ring]), 1_percent)
          << size;
  }
}

TEST (ConcaveOutline, OfRoundedCoordinatesHasNoHoles)
{
  RandomGenerator generator (seedOfTest());
  for (const double step : {0.1, 0.2, 0.5}) { // [m]
    PlanarPoints wall;                        // of 2 m x 1 m
    while (wall.size() < 20000)
      wall.emplace_back (step * std::round (2_m * drawUnit (generator) / step),
                         step * std::round (1_m * drawUnit (generator) / step));
    const PlanarRings outline = concaveOutline (wall);
    ASSERT_EQ (outline.size(), 1u) << step;
    EXPECT_NEAR (areaOf (outline[0]), 2.0, 1e-9) << step;
  }
}

TEST (ConcaveOutline, OfPlatesWithRoundHolesCanBeTriangulated)
{
  // Some of the holes come so near to each other or to the rim that both have a point.
  constexpr int holes = 4, points_of_plate = 3000;
  RandomGenerator generator;
  const auto drawPosition = [&] (double side) {
    return Eigen::Vector2d (side * (drawUnit (generator) - 0.5),
                            side * (drawUnit (generator) - 0.5));
  };
  int with_holes = 0;
  for (int plate = 0; plate < 60; ++plate) {
    PlanarPoints centers (holes);
    for (Eigen::Vector2d& center : centers)
      center = drawPosition (1.4);
    PlanarPoints points;
    while (points.size() < points_of_plate) {
      const Eigen::Vector2d point = drawPosition (2.0);
      if (std::none_of (centers.begin(), centers.end(), [&] (const auto& center) {
            return (point - center).norm() < 0.3;
          }))
        points.push_back (point);
    }
    const PlanarRings rings = concaveOutline (points);
    with_holes += rings.size() > 1 ? 1 : 0;
    EXPECT_FALSE (triangulate (rings).empty()) << "plate " << plate;
  }
  EXPECT_GT (with_holes, 20);
}

TEST (ConcaveOutline, HasHolesByFallingArea)
{
  PlanarPoints wall = gridOf (150, isInWall);
  // A second, smaller hole of some 40 cm x 40 cm.
  const auto isInVent = [] (const Eigen::Vector2d& point) {
    return (point - Eigen::Vector2d (2.5, 2.0)).lpNorm<Eigen::Infinity>() < 0.2;
  };
  wall.erase (std::remove_if (wall.begin(), wall.end(), isInVent), wall.end());
  const PlanarRings outline = concaveOutline (wall);
  ASSERT_EQ (outline.size(), 3u);
  // Holes run clockwise: their areas are below 0.
  EXPECT_LT (areaOf (outline[1]), areaOf (outline[2]));
}

TEST (ConcavePlaneExtent, OfTheInliersOfAStandingWallHasItsWindow)
{
  pcl::PointCloud<pcl::PointXYZ> cloud;
  for (const Eigen::Vector2d& point : gridOf (150, isInWall))
    cloud.push_back (toPoint ({point.x(), 2.0, point.y()}));
  const auto inliers = upTo<pcl::Indices> (cloud.size());
  cloud.push_back (toPoint ({10.0, 2.0, 0.0})); // of another plane
  const PlaneSegment wall = planeOfPoints (cloud, inliers, Eigen::Vector3d::UnitY());
  const PlaneExtent extent = concavePlaneExtent (cloud, wall);
  EXPECT_NEAR (
      extent.area, area_with_window - area_of_window, 1_percent * area_with_window);
  EXPECT_NEAR (extent.length, 3.0, 1_mm);
  ASSERT_EQ (extent.holes.size(), 1u);
  for (const Eigen::Vector3d& corner : extent.holes[0])
    EXPECT_NEAR (corner.y(), 2.0, 1e-6);
}
