// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <simulation/draws.h>
#include <simulation/walk.h>

#include <algorithm>

using namespace pcl_ops::simulation;

namespace {

DepthCamera
cameraOfAWalk ()
{
  DepthCamera camera;
  camera.width = 64;
  camera.height = 48;
  return camera;
}

double
degreesBetween (const Eigen::Isometry3d& one, const Eigen::Isometry3d& other)
{
  return Eigen::AngleAxisd (one.linear().transpose() * other.linear()).angle() * 180.0 /
         pi;
}

} // namespace

TEST (Walk, StaysInTheRoom)
{
  const Room room = makeRoom (1);
  for (const Eigen::Isometry3d& pose : drawWalk (room, cameraOfAWalk(), 20, 1)) {
    const Eigen::Vector3d inside =
        Eigen::AngleAxisd (-room.yaw, Eigen::Vector3d::UnitZ()) * pose.translation();
    EXPECT_LT (std::abs (inside.x()), 0.5 * room.size.x());
    EXPECT_LT (std::abs (inside.y()), 0.5 * room.size.y());
  }
}

TEST (Walk, SeesSurfacesAllTheWay)
{
  DepthCamera camera = cameraOfAWalk();
  for (std::uint32_t seed = 16; seed <= 25; ++seed) {
    const Room room = makeRoom (seed);
    int fewest = 100;
    for (const Eigen::Isometry3d& pose : drawWalk (room, camera, 12, seed)) {
      camera.pose = pose;
      fewest = std::min (fewest, countVisibleSurfaces (room.scene, camera));
    }
    EXPECT_GE (fewest, 3) << seed;
  }
}

TEST (Walk, GoesInSmallStepsAndLooksMostWaysInTheEnd)
{
  const Poses poses = drawWalk (makeRoom (2), cameraOfAWalk(), 50, 2);
  double turned = 0.0;
  for (std::size_t i = 1; i < poses.size(); ++i) {
    EXPECT_LT ((poses[i].translation() - poses[i - 1].translation()).norm(), 0.4);
    EXPECT_LT (degreesBetween (poses[i], poses[i - 1]), 15.0);
    turned += degreesBetween (poses[i], poses[i - 1]);
  }
  EXPECT_GT (turned, 250.0);
}

TEST (Walk, IsMeasuredAsWellAsAsked)
{
  const Poses truth (2000, Eigen::Isometry3d::Identity());
  EXPECT_TRUE (measured (truth, {}, 1)[7].isApprox (truth[7]));
  double degrees = 0.0, shift = 0.0;
  const Poses off = measured (truth, {3.0, 0.0}, 1);
  for (std::size_t i = 0; i < truth.size(); ++i) {
    degrees += std::pow (degreesBetween (off[i], truth[i]), 2);
    shift += off[i].translation().squaredNorm();
  }
  EXPECT_NEAR (std::sqrt (degrees / 2000), 3.0, 0.15);
  EXPECT_NEAR (std::sqrt (shift / 2000), 0.03, 0.0015);
}

TEST (Walk, DriftsFromWhereItBegan)
{
  const Poses truth (400, Eigen::Isometry3d::Identity());
  const Poses off = measured (truth, {0.0, 0.1}, 1);
  EXPECT_TRUE (off[0].isApprox (truth[0]));
  EXPECT_LT (degreesBetween (off[1], off[0]), 0.5);
  EXPECT_GT (off[399].translation().norm(), 5.0 * off[1].translation().norm());
}
