// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <io/shifted_cloud.h>
#include <pcl_ops/visibility.h>

#include <filesystem>

namespace fs = std::filesystem;
using Eigen::Vector3d;
using namespace pcl_ops;

namespace {

/** \brief All lidar scans of the data, which are in the frames of their sensors. */
std::vector<fs::path>
lidarScans ()
{
  std::vector<fs::path> scans;
  for (const std::string folder : {"lidar", "real", "wild"})
    if (fs::exists (fs::path (PCL_OPS_DATA_DIR) / folder))
      for (const auto& entry :
           fs::directory_iterator (fs::path (PCL_OPS_DATA_DIR) / folder)) {
        const fs::path& file = entry.path();
        const bool is_cloud = file.extension() == ".pcd" || file.extension() == ".xyz";
        if (is_cloud &&
            (folder == "lidar" || file.filename().string().rfind ("lidar", 0) == 0))
          scans.push_back (file);
      }
  return scans;
}

} // namespace

TEST (SeenFrom, IsTrueOfLidarScansFromTheSensorAndFalseFromPlacesBesideIt)
{
  const std::vector<fs::path> scans = lidarScans();
  if (scans.empty())
    GTEST_SKIP() << "no lidar scans in " << PCL_OPS_DATA_DIR;
  for (const fs::path& file : scans) {
    const auto cloud =
        apps::shiftedCloudOf (apps::loadCloud (file.string()), 0.0).cloud;
    const CloudView view (*cloud);
    EXPECT_TRUE (isSeenFrom (Vector3d::Zero(), view)) << file;
    for (int way = 0; way < 8; ++way) {
      const double angle = way * M_PI / 4.0;
      const Vector3d beside (3.0 * std::cos (angle), 3.0 * std::sin (angle), 0.0);
      EXPECT_FALSE (isSeenFrom (beside, view)) << file << " " << beside.transpose();
    }
    EXPECT_FALSE (isSeenFrom (Vector3d (0.0, 0.0, -3.0), view)) << file;
  }
}
