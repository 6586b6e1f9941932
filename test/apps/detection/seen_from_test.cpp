// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <io/shifted_cloud.h>
#include <pcl_ops/visibility.h>
#include <support/lidar_scans.h>

using Eigen::Vector3d;
using namespace pcl_ops;

// isSeenFrom is code of src/planes; only tests of programs read the files of scans.
TEST (IsSeenFrom, IsTrueOfTheSensorOfALidarScanAndFalse3MetersBesideAndBelowIt)
{
  const auto scans = lidarScansIn (PCL_OPS_DATA_DIR);
  if (scans.empty())
    GTEST_SKIP() << "no lidar scans in " << PCL_OPS_DATA_DIR;
  for (const auto& file : scans) {
    const auto shifted = apps::shiftedCloudOf (apps::loadCloud (file.string()));
    ASSERT_EQ (shifted.shift, Vector3d (Vector3d::Zero()))
        << file << ": the sensor is no longer at zero";
    const CloudView view (*shifted.cloud);
    EXPECT_TRUE (isSeenFrom (Vector3d::Zero(), view)) << file;
    constexpr double distance = 3.0; // of the wrong positions from the sensor [m]
    constexpr int directions = 8;
    for (int direction = 0; direction < directions; ++direction) {
      const double angle = direction * M_PI / 4.0;
      const Vector3d beside (
          distance * std::cos (angle), distance * std::sin (angle), 0.0);
      EXPECT_FALSE (isSeenFrom (beside, view)) << file << " " << beside.transpose();
    }
    EXPECT_FALSE (isSeenFrom (Vector3d (0.0, 0.0, -distance), view)) << file;
  }
}
