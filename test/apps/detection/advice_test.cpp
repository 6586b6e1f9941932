// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <detection/advice.h>

#include <cmath>
#include <functional>
#include <limits>

using namespace pcl_ops;
using namespace pcl_ops::apps;

/** The hint on thick planes for a surface of 4 m x 4 m, whose points, 5 cm apart in x
 * and y, are all taken for one plane; empty if there is no hint.
 * \param[in] height_at returns z at x and y [m] */
std::string
hintOnSurface (const std::function<double (double, double)>& height_at)
{
  XyzCloud cloud;
  PlaneSegment plane;
  constexpr int steps = 80;
  constexpr double spacing = 0.05; // [m]
  for (int i = 0; i < steps * steps; ++i) {
    const double x = spacing * (i / steps), y = spacing * (i % steps);
    const double z = height_at (x, y);
    cloud.emplace_back (float (x), float (y), float (z));
    plane.moments.add (x, y, z);
    plane.inliers.push_back (i);
  }
  return hintOnThickPlanes (cloud, {plane});
}

TEST (Advice, IsToGiveAVoxelSizeWhereAHillIsOnePlane)
{
  const std::string hint =
      hintOnSurface ([] (double x, double y) { return std::sin (x) * std::cos (y); });
  EXPECT_NE (hint.find ("100 % of the points on planes"), std::string::npos) << hint;
  EXPECT_NE (hint.find ("--voxel-size 0.1"), std::string::npos)
      << "twice the spacing: " << hint;
}

TEST (Advice, IsSilentOnAFloorThatBendsALittle)
{
  constexpr double amplitude = 0.005; // [m]
  EXPECT_EQ (hintOnSurface ([] (double x, double) { return amplitude * std::sin (x); }),
             "");
}

TEST (Advice, IsToRaiseAVoxelSizeThatLeavesOnePointInAVoxel)
{
  XyzCloud cloud; // points 1 m apart
  for (int i = 0; i < 100; ++i)
    cloud.emplace_back (float (i / 10), float (i % 10), 0.0f);
  OrientedPointSamplingParameters ops;
  ops.surfels.voxel_size = 0.1; // [m]
  EXPECT_EQ (adviceFor (ops, cloud, {}),
             "half of the points have 1 or fewer points within --voxel-size 0.1 of "
             "them: raise it, or leave it out");
  ops.surfels.voxel_size = 10.0;
  EXPECT_EQ (adviceFor (ops, cloud, {}).find ("--voxel-size"), std::string::npos);
}

TEST (Advice, TellsACloudOfFewPointsFromOneWithFewThatSinglePrecisionHolds)
{
  // Coordinates of a file beyond the largest number of single precision are infinite.
  constexpr float beyond = std::numeric_limits<float>::infinity();
  const OrientedPointSamplingParameters ops;
  XyzCloud cloud;
  for (const float x : {0.0f, 1.0f})
    cloud.emplace_back (x, 0.0f, 0.0f);
  EXPECT_EQ (adviceFor (ops, cloud, {}),
             "the cloud has 3 points or fewer, which tell no plane");
  for (int i = 0; i < 8; ++i)
    cloud.emplace_back (beyond, 0.0f, 0.0f);
  EXPECT_EQ (adviceFor (ops, cloud, {}),
             "all but 2 of 10 points are NaN or infinite in single precision (above "
             "3.4e38)");
}

TEST (Advice, IsGivenWherePlanesHaveLessThanATwentiethOfTheFinitePoints)
{
  constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();
  const OrientedPointSamplingParameters ops;
  constexpr int finite_points = 100;
  XyzCloud cloud;
  for (int i = 0; i < finite_points; ++i) {
    cloud.emplace_back (static_cast<float> (i), 0.0f, 0.0f);
    cloud.emplace_back (not_a_number, not_a_number, not_a_number);
  }
  for (const std::size_t inliers : {0, 4, 5}) {
    PlaneSegment plane;
    plane.inliers.resize (inliers);
    EXPECT_EQ (adviceFor (ops, cloud, {plane}).empty(), inliers >= finite_points / 20)
        << inliers;
  }
  EXPECT_EQ (adviceFor (ops, {}, {}),
             "every point is NaN or infinite in single precision (above 3.4e38)");
}
