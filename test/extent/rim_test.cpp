// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "base/random.h"
#include "extent/rim.h"
#include "geometry/planar_area.h"

#include <algorithm>
#include <cmath>

using namespace pcl_ops;
using namespace pcl_ops::internal;

namespace {

/** \brief Points of a turned plane whose coordinates have any size from 1e-10 to
 * 1e13, around their centroid. */
PlanarPoints
pointsOverManyDecades (std::uint32_t seed)
{
  RandomGenerator generator (seed);
  const Eigen::Matrix3d frame =
      (Eigen::AngleAxisd (6.28 * drawUnit (generator), Eigen::Vector3d::UnitZ()) *
       Eigen::AngleAxisd (6.28 * drawUnit (generator), Eigen::Vector3d::UnitX()))
          .toRotationMatrix();
  PlanarPoints points (600);
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (Eigen::Vector2d& point : points) {
    Eigen::Vector3d place;
    for (int axis = 0; axis < 3; ++axis) {
      const double sign = drawUnit (generator) < 0.5 ? -1.0 : 1.0;
      place[axis] = sign * std::pow (10.0, 23.0 * drawUnit (generator) - 10.0);
    }
    point = (frame * place).head<2>();
    sum += point;
  }
  for (Eigen::Vector2d& point : points)
    point -= sum / static_cast<double> (points.size());
  return points;
}

/** \brief How far a point is behind the line from one to another, negative before. */
double
distanceBehind (const Eigen::Vector2d& point,
                const Eigen::Vector2d& from,
                const Eigen::Vector2d& to)
{
  const Eigen::Vector2d along = (to - from).normalized(), there = point - from;
  return along.y() * there.x() - along.x() * there.y();
}

/** \brief Whole numbers 0 .. last in both directions. */
PlanarPoints
lattice (int last)
{
  PlanarPoints points;
  for (int x = 0; x <= last; ++x)
    for (int y = 0; y <= last; ++y)
      points.emplace_back (x, y);
  return points;
}

} // namespace

TEST (HullOfAll, HasTheCornersAlone)
{
  const PlanarPoints hull = hullOfAll (lattice (10));
  EXPECT_EQ (hull.size(), 4u);
  EXPECT_EQ (areaOf (hull), 100.0) << "above 0: counter-clockwise";
}

TEST (HullOfAll, HasAllPointsOverManyDecadesInside)
{
  constexpr double rounding = 1e-9 * 1e13;
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    const PlanarPoints points = pointsOverManyDecades (seed);
    const PlanarPoints hull = hullOfAll (points);
    ASSERT_GE (hull.size(), 3U);
    double farthest = 0.0;
    for (std::size_t i = 0; i < hull.size(); ++i)
      for (const Eigen::Vector2d& point : points)
        farthest = std::max (
            farthest, distanceBehind (point, hull[i], hull[(i + 1) % hull.size()]));
    EXPECT_LE (farthest, rounding) << "seed " << seed;
  }
}

TEST (Rim, TakesOffThePointsOnItsHull)
{
  Rim rim (lattice (4));
  EXPECT_EQ (areaOf (rim.hull()), 16.0);
  EXPECT_EQ (rim.takeOff (rim.hull(), 1), 16u) << "5 x 5 points with 3 x 3 inside";
  EXPECT_EQ (areaOf (rim.hull()), 4.0);
}

TEST (Rim, TakesOffAsManyAsWantedOrMore)
{
  Rim rim (lattice (10));
  EXPECT_GE (rim.takeOff (rim.hull(), 50), 50u) << "40 are on the hull";
}

TEST (Rim, KeepsTheHullOfManyPoints)
{
  EXPECT_EQ (areaOf (Rim (lattice (100)).hull()), 10000.0) << "most are set aside";
}
