// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <detection/thickness.h>
#include <numbers/random.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace {

using namespace pcl_ops;
using namespace pcl_ops::apps;

constexpr double usual_noise = 0.01;   // [m]
constexpr double usual_spacing = 0.05; // [m]

/** A level square of 60 x 60 points.
 * \param[in] spacing distance of neighboring points [m]
 * \param[in] noise standard deviation of the Gaussian noise of the heights [m]
 * \param[in] height of the square [m] */
XyzCloud
square (double spacing, double noise, double height = 0.0)
{
  Random random (1);
  XyzCloud cloud;
  constexpr int steps = 60;
  for (int i = 0; i < steps * steps; ++i)
    cloud.emplace_back (float (spacing * (i / steps)),
                        float (spacing * (i % steps)),
                        float (height + noise * random.gaussian()));
  return cloud;
}

/** All points of a cloud as one plane. */
PlaneSegment
planeOf (const XyzCloud& cloud)
{
  PlaneSegment plane;
  plane.inliers.resize (cloud.size());
  std::iota (plane.inliers.begin(), plane.inliers.end(), 0);
  for (const pcl::PointXYZ& point : cloud)
    plane.moments.add (point.x, point.y, point.z);
  return plane;
}

/** The thickness of all points of a cloud as one plane. */
Thickness
thicknessOfAll (const XyzCloud& cloud)
{
  return thicknessOf (cloud, {planeOf (cloud)}).at (0);
}

TEST (Thickness, OfAPlaneWithNoiseIsItsNoise)
{
  const Thickness thickness = thicknessOfAll (square (usual_spacing, usual_noise));
  EXPECT_NEAR (thickness.rms, usual_noise, 0.1 * usual_noise);
  EXPECT_NEAR (thickness.noise, usual_noise, 0.2 * usual_noise);
  EXPECT_NEAR (thickness.spacing, usual_spacing, 0.01);
}

TEST (Thickness, OfTwoSidesOfAWallAsOnePlaneIsFarAboveTheirNoise)
{
  // The points are 2 cm apart: the neighborhood of a point is on one side.
  constexpr double spacing = 0.02, noise = 0.002, width_of_wall = 0.2; // [m]
  const Thickness thickness =
      thicknessOfAll (square (spacing, noise) + square (spacing, noise, width_of_wall));
  EXPECT_NEAR (thickness.rms, 0.5 * width_of_wall, 0.001);
  EXPECT_GT (thickness.factor(), 4.0 * thick_factor);
}

TEST (Thickness, OfExactPointsIsNearZeroThoughSinglePrecisionRoundsThem)
{
  constexpr double no_noise = 0.0;
  XyzCloud cloud = square (usual_spacing, no_noise);
  for (pcl::PointXYZ& point : cloud)
    point.z = 0.3f * point.x + 0.1f * point.y + 100.0f;
  EXPECT_LT (thicknessOfAll (cloud).factor(), 0.1);
}

TEST (Thickness, OfScanLinesIsMeasuredAcrossThem)
{
  // Lines are 30 cm apart, every second one is 10 cm higher, their points are 2 cm
  // apart. Points of one line do not scatter, those of several lines do, as all points.
  XyzCloud cloud;
  for (int line = 0; line < 30; ++line)
    for (int i = 0; i < 400; ++i)
      cloud.emplace_back (
          0.02f * float (i), 0.3f * float (line), 0.1f * float (line % 2));
  EXPECT_LT (thicknessOfAll (cloud).factor(), 2.0);
}

TEST (Thickness, DoesNotDependOnTheOrderOfThePoints)
{
  XyzCloud cloud =
      square (usual_spacing, usual_noise) + square (usual_spacing, usual_noise, 0.15);
  const Thickness before = thicknessOfAll (cloud);
  std::reverse (cloud.begin(), cloud.end());
  std::swap (cloud[7], cloud[4000]); // any two: the order is no plain reversal
  EXPECT_DOUBLE_EQ (thicknessOfAll (cloud).noise, before.noise);
}

TEST (Thickness, IsTheSameForFewProbesAsForMany)
{
  // Up to 50 probes compare all points; more probes sort the points first.
  constexpr std::size_t most_without_sorting = 50;
  const XyzCloud cloud = square (usual_spacing, usual_noise);
  const auto noiseByProbes = [&cloud] (std::size_t probes) {
    return thicknessOf (cloud, {planeOf (cloud)}, probes).at (0).noise;
  };
  EXPECT_NEAR (noiseByProbes (most_without_sorting),
               noiseByProbes (most_without_sorting + 1),
               0.01 * usual_noise);
}

TEST (Thickness, OfPointsOnALineIsNaN)
{
  XyzCloud cloud;
  for (int i = 0; i < 100; ++i)
    cloud.emplace_back (float (i), 0.0f, 0.0f);
  EXPECT_TRUE (std::isnan (thicknessOfAll (cloud).factor()));
}

} // namespace
