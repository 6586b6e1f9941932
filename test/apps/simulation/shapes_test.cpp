// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_checks.h"
#include "simulated_scene.h"
#include <simulation/shapes.h>

using namespace pcl_ops::simulation;

namespace {

using Eigen::Vector3d;

constexpr std::size_t few_points = 5000;

/** \brief Distance of a point from a shape's axis along z and its height above it. */
std::pair<double, double>
aroundAxis (const Vector3d& point, const Vector3d& zero)
{
  const Vector3d local = point - zero;
  return {local.head<2>().norm(), local.z()};
}

double
distance (const Sphere& sphere, const Vector3d& point)
{
  return std::abs ((point - sphere.center).norm() - sphere.radius);
}

double
distance (const Cylinder& cylinder, const Vector3d& point)
{
  const auto [across, height] = aroundAxis (point, cylinder.center);
  return std::hypot (across - cylinder.radius,
                     std::max (0.0, std::abs (height) - cylinder.half_length));
}

double
distance (const Cone& cone, const Vector3d& point)
{
  const auto [across, height] = aroundAxis (point, cone.apex);
  return std::abs (cone.height * across + cone.radius * height) /
         std::hypot (cone.height, cone.radius);
}

double
distance (const Torus& torus, const Vector3d& point)
{
  const auto [across, height] = aroundAxis (point, torus.center);
  return std::abs (std::hypot (across - torus.radius, height) - torus.tube_radius);
}

double
distanceToRoundShapes (const Shapes& shapes, const Vector3d& point)
{
  return std::min ({distance (shapes.sphere, point),
                    distance (shapes.cylinder, point),
                    distance (shapes.cone, point),
                    distance (shapes.torus, point)});
}

double
largestDistanceToRoundShapes (std::uint32_t seed, double noise_scale)
{
  const Shapes shapes = makeShapes (seed);
  double largest = 0.0;
  for (const auto& point : scanShapes (shapes, few_points, noise_scale, seed).cloud)
    if (point.label == 0)
      largest = std::max (
          largest,
          distanceToRoundShapes (shapes, point.getVector3fMap().cast<double>()));
  return largest;
}

} // namespace

TEST (Shapes, AreTwoPlanesAndPointsOnNone)
{
  const auto simulated =
      scanShapes (makeShapes (seedOfTest()), few_points, 1.0, seedOfTest());
  EXPECT_EQ (simulated.cloud.size(), few_points);
  EXPECT_EQ (simulated.planes.size(), 2u);
  EXPECT_GT (few_points - simulated.planes[0].points - simulated.planes[1].points,
             few_points / 5);
}

TEST (Shapes, ExactPointsOfNoPlaneLieOnTheRoundSurfaces)
{
  EXPECT_LT (largestDistanceToRoundShapes (seedOfTest(), 0.0), rounding);
}

TEST (Shapes, NoisyPointsOfNoPlaneLieAroundTheRoundSurfaces)
{
  const double largest = largestDistanceToRoundShapes (seedOfTest(), 1.0);
  EXPECT_LT (largest, shapes_sigma * largest_gaussian);
  EXPECT_GT (largest, shapes_sigma * 2.0);
}

TEST (Shapes, ExactPointsLieOnThePlaneOfTheirLabel)
{
  const auto simulated =
      scanShapes (makeShapes (seedOfTest()), few_points, 0.0, seedOfTest());
  EXPECT_LT (largestDistanceToTruth (simulated), rounding);
}

TEST (Shapes, RoundOnesStandApartFromThePlanes)
{
  for (std::uint32_t seed = seedOfTest(), last = seed + 20; seed != last; ++seed)
    for (const auto& point :
         scanShapes (makeShapes (seed), few_points, 0.0, seed).cloud) {
      if (point.label == 0) {
        EXPECT_LT (point.y, -0.3f) << seed;
      }
      else {
        EXPECT_GE (point.y, 0.0f) << seed;
      }
    }
}

TEST (Shapes, RoundOnesStandApartFromEachOther)
{
  for (std::uint32_t seed = seedOfTest(), last = seed + 20; seed != last; ++seed) {
    const Shapes shapes = makeShapes (seed);
    const double gaps[] = {shapes.cylinder.center.x() - shapes.sphere.center.x() -
                               shapes.cylinder.radius - shapes.sphere.radius,
                           shapes.cone.apex.x() - shapes.cylinder.center.x() -
                               shapes.cone.radius - shapes.cylinder.radius,
                           shapes.torus.center.x() - shapes.cone.apex.x() -
                               shapes.torus.radius - shapes.torus.tube_radius -
                               shapes.cone.radius};
    for (const double gap : gaps)
      EXPECT_GT (gap, 0.3) << seed;
  }
}

TEST (Shapes, SameSeedSameCloud)
{
  const std::uint32_t seed = seedOfTest();
  const Shapes shapes = makeShapes (seed);
  const auto first = scanShapes (shapes, few_points, 1.0, seed);
  EXPECT_TRUE (haveSamePoints (first, scanShapes (shapes, few_points, 1.0, seed)));
  EXPECT_FALSE (haveSamePoints (first, scanShapes (shapes, few_points, 1.0, seed + 1)));
  EXPECT_NE (shapes.sphere.radius, makeShapes (seed + 1).sphere.radius);
}

TEST (SurfacePoints, AConeIsDenseEvenlyFromTheApexDown)
{
  Cone cone;
  pcl_ops::internal::RandomGenerator generator (seedOfTest());
  int in_upper_half = 0;
  for (int i = 0; i < 10000; ++i)
    in_upper_half += drawPoint (cone, generator).position.z() > -0.5 * cone.height;
  EXPECT_NEAR (in_upper_half, 2500, 150);
}

TEST (SurfacePoints, ATorusIsDenseEvenlyInsideAndOutside)
{
  Torus torus;
  pcl_ops::internal::RandomGenerator generator (seedOfTest());
  int outside = 0;
  for (int i = 0; i < 10000; ++i)
    outside += drawPoint (torus, generator).position.head<2>().norm() > torus.radius;
  const double share = 0.5 + torus.tube_radius / torus.radius / pi;
  EXPECT_NEAR (outside, 10000 * share, 150);
}
