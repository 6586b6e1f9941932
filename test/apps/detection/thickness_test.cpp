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

constexpr double noise = 0.01; // [m]

/** A level square of 60 x 60 points with noise.
 * \param[in] spacing distance of neighboring points [m]
 * \param[in] standard_deviation of the noise [m]
 * \param[in] height of the square [m] */
XyzCloud
square (double spacing, double standard_deviation, double height = 0.0)
{
  Random random (1);
  XyzCloud cloud;
  constexpr int steps = 60;
  for (int i = 0; i < steps * steps; ++i)
    cloud.emplace_back (float (spacing * (i / steps)),
                        float (spacing * (i % steps)),
                        float (height + standard_deviation * random.gaussian()));
  return cloud;
}

/** All points as one plane. */
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

Thickness
thicknessOfAll (const XyzCloud& cloud)
{
  return thicknessOf (cloud, {planeOf (cloud)}).at (0);
}

TEST (Thickness, OfAPlaneWithNoiseIsItsNoise)
{
  const Thickness thickness = thicknessOfAll (square (0.05, noise));
  EXPECT_NEAR (thickness.rms, noise, 0.1 * noise);
  EXPECT_NEAR (thickness.noise, noise, 0.2 * noise);
  EXPECT_NEAR (thickness.spacing, 0.05, 0.01);
}

TEST (Thickness, OfTwoSidesOfAWallAsOnePlaneIsFarAboveTheirNoise)
{
  // The sides are 20 cm apart, points 2 cm: the neighborhood of a point is on one side.
  const Thickness thickness =
      thicknessOfAll (square (0.02, 0.002) + square (0.02, 0.002, 0.2));
  EXPECT_NEAR (thickness.rms, 0.1, 0.001);
  EXPECT_GT (thickness.factor(), 4.0 * thick_factor);
}

TEST (Thickness, OfExactPointsIsNoneWhateverTheirRounding)
{
  // A slope: single precision rounds its heights.
  XyzCloud cloud = square (0.05, 0.0);
  for (pcl::PointXYZ& point : cloud)
    point.z = 0.3f * point.x + 0.1f * point.y + 100.0f;
  EXPECT_LT (thicknessOfAll (cloud).factor(), 0.1);
}

TEST (Thickness, OfRingsIsMeasuredAcrossThem)
{
  // Lines are 30 cm apart, every second one is 10 cm higher. Points of one line do not
  // scatter, those of several lines do: the noise has to be measured across lines.
  XyzCloud cloud;
  for (int line = 0; line < 30; ++line)
    for (int i = 0; i < 400; ++i)
      cloud.emplace_back (
          0.02f * float (i), 0.3f * float (line), 0.1f * float (line % 2));
  EXPECT_LT (thicknessOfAll (cloud).factor(), 2.0);
}

TEST (Thickness, DoesNotDependOnTheOrderOfThePoints)
{
  XyzCloud cloud = square (0.05, noise) + square (0.05, noise, 0.15);
  const Thickness before = thicknessOfAll (cloud);
  std::reverse (cloud.begin(), cloud.end());
  std::swap (cloud[7], cloud[4000]);
  EXPECT_DOUBLE_EQ (thicknessOfAll (cloud).noise, before.noise);
}

TEST (Thickness, IsTheSameForFewProbesAsForMany)
{
  // With up to 50 probes in all, the points are not sorted for the search of neighbors.
  const XyzCloud cloud = square (0.05, noise);
  const double few = thicknessOf (cloud, {planeOf (cloud)}, 50).at (0).noise;
  const double more = thicknessOf (cloud, {planeOf (cloud)}, 51).at (0).noise;
  EXPECT_NEAR (few, more, 0.01 * noise);
}

TEST (Thickness, OfPointsOnALineIsNotKnown)
{
  XyzCloud cloud;
  for (int i = 0; i < 100; ++i)
    cloud.emplace_back (float (i), 0.0f, 0.0f);
  EXPECT_TRUE (std::isnan (thicknessOfAll (cloud).factor()));
}

} // namespace
