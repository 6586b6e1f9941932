// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "simulated_scenes.h"
#include <simulation/shapes.h>

#include <limits>

using namespace pcl_ops::simulation;

namespace {

using Eigen::Vector3d;

constexpr std::size_t few_points = 5000;

double
distance (const Dome& dome, const Vector3d& point)
{
  const double lowest = dome.center.z() + dome.radius - dome.height;
  return std::hypot ((point - dome.center).norm() - dome.radius,
                     std::max (0.0, lowest - point.z()));
}

double
distance (const Cylinder& cylinder, const Vector3d& point)
{
  const Vector3d local = point - cylinder.center;
  return std::hypot (local.head<2>().norm() - cylinder.radius,
                     std::max (0.0, std::abs (local.z()) - cylinder.half_length));
}

double
distance (const Cone& cone, const Vector3d& point)
{
  const Vector3d local = point - cone.apex;
  return std::abs (cone.height * local.head<2>().norm() + cone.radius * local.z()) /
         std::hypot (cone.height, cone.radius);
}

double
distance (const Torus& torus, const Vector3d& point)
{
  const Vector3d local = point - torus.center;
  return std::abs (std::hypot (local.head<2>().norm() - torus.radius, local.z()) -
                   torus.tube_radius);
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
largestDistanceToRoundShapes (std::uint32_t seed, double noise_scale)
{
  const Shapes shapes = makeShapes (seed);
  double largest = 0.0;
  for (const auto& found : scanShapes (shapes, few_points, noise_scale, seed).cloud) {
    const Vector3d point = found.getVector3fMap().cast<double>();
    double smallest = std::numeric_limits<double>::infinity();
    for (const RoundShapes& row : {shapes.small, shapes.large})
      smallest = std::min ({smallest,
                            distance (row.dome, point),
                            distance (row.cylinder, point),
                            distance (row.cone, point),
                            distance (row.torus, point)});
    if (found.label == 0)
      largest = std::max (largest, smallest);
  }
  return largest;
}

/** \brief How many of 10,000 points drawn from a shape \p isCounted says yes to. */
template <typename Shape, typename IsCounted>
int
countDrawn (const Shape& shape, const IsCounted& isCounted)
{
  Random random (seedOfTest());
  int counted = 0;
  for (int i = 0; i < 10000; ++i)
    counted += isCounted (drawPoint (shape, random));
  return counted;
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

TEST (Shapes, PointsOfNoPlaneLieOnTheRoundSurfaces)
{
  EXPECT_LT (largestDistanceToRoundShapes (seedOfTest(), 0.0), rounding);
  const double noisy = largestDistanceToRoundShapes (seedOfTest(), 1.0);
  EXPECT_LT (noisy, shapes_sigma * largest_gaussian);
  EXPECT_GT (noisy, shapes_sigma * 2.0);
}

TEST (Shapes, RoundOnesStandApartFromThePlanesAndEachOther)
{
  struct Row {
    float front, back, spacing, gap; // [m]
  };
  for (const std::uint32_t seed : seedsOfTest (20)) {
    const auto cloud = scanShapes (makeShapes (seed), few_points, 0.0, seed).cloud;
    for (const auto& point : cloud)
      EXPECT_TRUE (point.label == 0 ? point.y < -0.3f : point.y >= 0.0f) << seed;
    for (const Row& row : {Row{-0.3f, -2.1f, 1.8f, 0.3f}, {-2.5f, -99, 3.0f, 0.2f}}) {
      Eigen::AlignedBox1d of_shape[4];
      for (const auto& point : cloud) {
        EXPECT_FALSE (point.y > -2.5f && point.y < -2.1f) << seed;
        if (point.y < row.front && point.y > row.back)
          of_shape[std::clamp (int (point.x / row.spacing + 2.0f), 0, 3)].extend (
              Eigen::AlignedBox1d::VectorType (point.x));
      }
      for (int i = 1; i < 4; ++i)
        EXPECT_GT (of_shape[i].min()[0] - of_shape[i - 1].max()[0], row.gap) << seed;
    }
  }
}

TEST (Shapes, RadiiOfLargeOnesReachFromThoseOfTheOthersToThoseOfVaults)
{
  double smallest = 10.0, largest = 0.0;
  for (const std::uint32_t seed : seedsOfTest (20)) {
    const RoundShapes row = makeShapes (seed).large;
    for (const double radius : {row.dome.radius,
                                row.cylinder.shape.radius,
                                row.cone.shape.radius,
                                row.torus.shape.radius}) {
      smallest = std::min (smallest, radius);
      largest = std::max (largest, radius);
    }
  }
  EXPECT_GT (smallest, 0.5);
  EXPECT_LT (smallest, 1.0);
  EXPECT_GT (largest, 4.0);
}

TEST (SurfacePoints, AreDenseEvenly)
{
  const Cone cone;
  const int in_upper_half = countDrawn (cone, [&cone] (const SurfacePoint& point) {
    return point.position.z() > -0.5 * cone.height;
  });
  EXPECT_NEAR (in_upper_half, 2500, 150);

  Dome dome;
  dome.height = 0.2;
  const int above_middle = countDrawn (
      dome, [] (const SurfacePoint& point) { return point.position.z() > 0.9; });
  EXPECT_NEAR (above_middle, 5000, 200); // Archimedes

  const Torus torus;
  const int outside = countDrawn (torus, [&torus] (const SurfacePoint& point) {
    return point.position.head<2>().norm() > torus.radius;
  });
  const double share = 0.5 + torus.tube_radius / torus.radius / pi;
  EXPECT_NEAR (outside, 10000 * share, 150);
}

TEST (SurfacePoints, ASectorIsDenseEvenlyAboutItsMiddle)
{
  Sector<Cylinder> quarter;
  quarter.share = 0.25;
  const int in_middle_half = countDrawn (quarter, [] (const SurfacePoint& point) {
    const double around = std::atan2 (point.position.x(), point.position.y());
    EXPECT_LE (std::abs (around), 0.25 * pi + 1e-9);
    EXPECT_GT (point.normal.dot (point.position), 0.0);
    return std::abs (around) < 0.125 * pi;
  });
  EXPECT_NEAR (in_middle_half, 5000, 200);
}
