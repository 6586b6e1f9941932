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
 * and y, are all taken for one plane.
 * \param[in] height returns z at x and y [m] */
std::string
hintOn (const std::function<double (double, double)>& height)
{
  XyzCloud cloud;
  PlaneSegment plane;
  constexpr int steps = 80;
  for (int i = 0; i < steps * steps; ++i) {
    const double x = 0.05 * (i / steps), y = 0.05 * (i % steps);
    cloud.emplace_back (float (x), float (y), float (height (x, y)));
    plane.moments.add (x, y, height (x, y));
    plane.inliers.push_back (i);
  }
  return hintOnThickPlanes (cloud, {plane});
}

TEST (Advice, NamesAVoxelSizeWhereAHillIsAPlane)
{
  const std::string hint =
      hintOn ([] (double x, double y) { return std::sin (x) * std::cos (y); });
  EXPECT_NE (hint.find ("100 % of the points on planes"), std::string::npos) << hint;
  EXPECT_NE (hint.find ("--voxel-size 0.1"), std::string::npos) << hint;
}

TEST (Advice, IsSilentOnAFloorThatBendsALittle)
{
  EXPECT_EQ (hintOn ([] (double x, double) { return 0.005 * std::sin (x); }), "");
}

TEST (Advice, NamesTheVoxelSizeWhereVoxelsHoldHardlyAPoint)
{
  OrientedPointSamplingParameters ops;
  XyzCloud cloud;
  for (int i = 0; i < 100; ++i)
    cloud.emplace_back (float (i / 10), float (i % 10), 0.0f);
  ops.surfels.voxel_size = 0.1;
  EXPECT_EQ (
      adviceFor (ops, cloud, {}),
      "half of the voxels of --voxel-size 0.1 hold 1 points or fewer: raise it, or "
      "leave it out");
  ops.surfels.voxel_size = 10.0;
  EXPECT_EQ (adviceFor (ops, cloud, {}).find ("--voxel-size"), std::string::npos);
}

TEST (Advice, IsGivenWherePlanesHaveLessThanATwentiethOfTheReadings)
{
  constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();
  const OrientedPointSamplingParameters ops;
  XyzCloud cloud;
  for (int i = 0; i < 100; ++i) {
    cloud.emplace_back (static_cast<float> (i), 0.0f, 0.0f);
    cloud.emplace_back (not_a_number, not_a_number, not_a_number);
  }
  for (const auto& [inliers, is_hardly_covered] :
       {std::pair (0, true), std::pair (4, true), std::pair (5, false)}) {
    PlaneSegment plane;
    plane.inliers.resize (inliers);
    EXPECT_NE (adviceFor (ops, cloud, {plane}).empty(), is_hardly_covered) << inliers;
  }
  EXPECT_EQ (adviceFor (ops, {}, {}), "every point is NaN or infinite");
}
