// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <detection/advice.h>

#include <limits>

using namespace pcl_ops;

namespace {

/** \brief Whether of 100 readings and as many missing ones \p covered on a plane are
 * next to none. */
bool
isHardlyCoveredBy (int covered)
{
  constexpr int readings = 100;
  constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();
  pcl::PointCloud<pcl::PointXYZ> cloud;
  for (int i = 0; i < readings; ++i) {
    cloud.push_back ({static_cast<float> (i), 0, 0});
    cloud.push_back ({not_a_number, not_a_number, not_a_number});
  }
  PlaneSegment plane;
  for (int i = 0; i < covered; ++i)
    plane.inliers.push_back (2 * i);
  return apps::isHardlyCovered (cloud, {plane});
}

} // namespace

TEST (Advice, IsGivenWherePlanesHaveLessThanATwentiethOfTheReadings)
{
  EXPECT_TRUE (isHardlyCoveredBy (0));
  EXPECT_TRUE (isHardlyCoveredBy (4));
  EXPECT_FALSE (isHardlyCoveredBy (5));
  EXPECT_TRUE (apps::isHardlyCovered ({}, {}));
}
