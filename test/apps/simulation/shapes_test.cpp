// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_checks.h"
#include "simulated_scene.h"
#include <simulation/shapes.h>

#include <limits>

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
distance (const Dome& dome, const Vector3d& point)
{
  const double lowest = dome.center.z() + dome.radius - dome.height;
  return std::hypot (distance (Sphere{dome.center, dome.radius}, point),
                     std::max (0.0, lowest - point.z()));
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

/** \brief That from the whole shape where a point is in the sector, else infinite. */
template <typename Shape>
double
distance (const Sector<Shape>& sector, const Vector3d& point)
{
  const Vector3d local = point - pointOnAxis (sector.shape);
  const double share = std::abs (std::atan2 (local.x(), local.y())) / pi;
  return share < sector.share + 1e-4 || local.head<2>().norm() < 0.01
             ? distance (sector.shape, point)
             : std::numeric_limits<double>::infinity();
}

double
distanceToRoundShapes (const Shapes& shapes, const Vector3d& point)
{
  return std::min ({distance (shapes.sphere, point),
                    distance (shapes.cylinder, point),
                    distance (shapes.cone, point),
                    distance (shapes.torus, point),
                    distance (shapes.large_sphere, point),
                    distance (shapes.large_cylinder, point),
                    distance (shapes.large_cone, point),
                    distance (shapes.large_torus, point)});
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

TEST (Shapes, LargeOnesStandBehindTheOthersApartFromEachOther)
{
  for (std::uint32_t seed = seedOfTest(), last = seed + 20; seed != last; ++seed) {
    Eigen::AlignedBox1d of_shape[4];
    for (const auto& point :
         scanShapes (makeShapes (seed), few_points, 0.0, seed).cloud) {
      EXPECT_FALSE (point.y > -2.5f && point.y < -2.1f) << seed;
      if (point.y < -2.5f)
        of_shape[std::clamp (int (point.x / 3.0 + 2.0), 0, 3)].extend (
            Eigen::AlignedBox1d::VectorType (point.x));
    }
    for (int i = 1; i < 4; ++i)
      EXPECT_GT (of_shape[i].min()[0] - of_shape[i - 1].max()[0], 0.2) << seed;
  }
}

TEST (Shapes, RadiiOfLargeOnesReachFromThoseOfTheOthersToThoseOfVaults)
{
  double smallest = 10.0, largest = 0.0;
  for (std::uint32_t seed = seedOfTest(), last = seed + 20; seed != last; ++seed) {
    const Shapes shapes = makeShapes (seed);
    for (const double radius : {shapes.large_sphere.radius,
                                shapes.large_cylinder.shape.radius,
                                shapes.large_cone.shape.radius,
                                shapes.large_torus.shape.radius}) {
      smallest = std::min (smallest, radius);
      largest = std::max (largest, radius);
    }
  }
  EXPECT_GT (smallest, 0.5);
  EXPECT_LT (smallest, 1.0);
  EXPECT_GT (largest, 4.0);
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

TEST (SurfacePoints, ADomeIsDenseEvenlyFromTheTopDown)
{
  Dome dome;
  dome.height = 0.2;
  pcl_ops::internal::RandomGenerator generator (seedOfTest());
  int in_upper_half = 0;
  for (int i = 0; i < 10000; ++i)
    in_upper_half += drawPoint (dome, generator).position.z() > 0.9;
  EXPECT_NEAR (in_upper_half, 5000, 200); // Archimedes
}

TEST (SurfacePoints, ASectorIsDenseEvenlyAboutItsMiddle)
{
  Sector<Cylinder> quarter;
  quarter.share = 0.25;
  pcl_ops::internal::RandomGenerator generator (seedOfTest());
  int in_middle_half = 0;
  for (int i = 0; i < 10000; ++i) {
    const SurfacePoint point = drawPoint (quarter, generator);
    const double around = std::atan2 (point.position.x(), point.position.y());
    EXPECT_LE (std::abs (around), 0.25 * pi + 1e-9);
    EXPECT_GT (point.normal.dot (point.position), 0.0);
    in_middle_half += std::abs (around) < 0.125 * pi;
  }
  EXPECT_NEAR (in_middle_half, 5000, 200);
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
