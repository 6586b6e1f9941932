// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <detection/advice.h>

#include <limits>

using namespace pcl_ops;
using namespace pcl_ops::apps;

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
