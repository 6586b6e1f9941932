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
distanceToWhole (const RoundShape& shape, const Vector3d& local)
{
  const double across = local.head<2>().norm(), z = local.z();
  switch (shape.kind) {
  case RoundShape::Kind::Cylinder:
    return std::hypot (across - shape.radius,
                       std::max (0.0, std::abs (z) - shape.height));
  case RoundShape::Kind::Cone:
    return std::abs (shape.height * across + shape.radius * z) /
           std::hypot (shape.height, shape.radius);
  case RoundShape::Kind::Torus:
    return std::abs (std::hypot (across - shape.radius, z) - shape.height);
  default:
    return std::hypot (local.norm() - shape.radius,
                       std::max (0.0, shape.radius - shape.height - z));
  }
}

/** \brief Infinite beside the part of a turn that there is. */
double
distance (const RoundShape& shape, const Vector3d& point)
{
  const Vector3d local = point - shape.center;
  const double share = std::abs (std::atan2 (local.x(), local.y())) / pi;
  return share < shape.share + 1e-4 || local.head<2>().norm() < 0.01
             ? distanceToWhole (shape, local)
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
    for (const RoundShape& shape : shapes.round)
      smallest = std::min (smallest, distance (shape, point));
    if (found.label == 0)
      largest = std::max (largest, smallest);
  }
  return largest;
}

/** \brief How many of 10,000 points drawn from a shape \p isCounted says yes to. */
template <typename IsCounted>
int
countDrawn (const RoundShape& shape, const IsCounted& isCounted)
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

TEST (SurfacePoints, AreDenseEvenly)
{
  using Kind = RoundShape::Kind;
  const RoundShape cone{Kind::Cone, Vector3d::Zero(), 0.5, 1.0};
  EXPECT_NEAR (countDrawn (cone, [] (const auto& p) { return p.position.z() > -0.5; }),
               2500,
               150);
  const RoundShape dome{Kind::Dome, Vector3d::Zero(), 1.0, 0.2};
  EXPECT_NEAR (countDrawn (dome, [] (const auto& p) { return p.position.z() > 0.9; }),
               5000, // Archimedes
               200);
  const RoundShape torus{Kind::Torus, Vector3d::Zero(), 0.5, 0.15};
  const auto isOutside = [] (const auto& p) {
    return p.position.template head<2>().norm() > 0.5;
  };
  EXPECT_NEAR (countDrawn (torus, isOutside), 10000 * (0.5 + 0.3 / pi), 150);
}

TEST (SurfacePoints, APartOfATurnIsDenseEvenlyAboutItsMiddle)
{
  const RoundShape quarter{
      RoundShape::Kind::Cylinder, Vector3d::Zero(), 0.1, 0.5, 0.25};
  const int in_middle_half = countDrawn (quarter, [] (const SurfacePoint& point) {
    const double around = std::atan2 (point.position.x(), point.position.y());
    EXPECT_LE (std::abs (around), 0.25 * pi + 1e-9);
    EXPECT_GT (point.normal.dot (point.position), 0.0);
    return std::abs (around) < 0.125 * pi;
  });
  EXPECT_NEAR (in_middle_half, 5000, 200);
}
