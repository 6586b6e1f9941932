// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "simulated_scenes.h"
#include <simulation/street.h>

using namespace pcl_ops::simulation;

namespace {

double
degreesBetween (const Eigen::Isometry3d& one, const Eigen::Isometry3d& other)
{
  return Eigen::AngleAxisd (one.linear().transpose() * other.linear()).angle() / degree;
}

double
stepOf (const Poses& poses, std::size_t i)
{
  return (poses[i].translation() - poses[i - 1].translation()).norm();
}

} // namespace

TEST (Walk, StaysInTheRoom)
{
  const Room room = makeRoom (1);
  for (const Eigen::Isometry3d& pose : drawWalk (room, 20, 1)) {
    const Eigen::Vector3d inside = turnZ (-room.yaw) * pose.translation();
    EXPECT_LT (std::abs (inside.x()), 0.5 * room.size.x());
    EXPECT_LT (std::abs (inside.y()), 0.5 * room.size.y());
  }
}

TEST (Walk, SeesSurfacesAllTheWay)
{
  for (std::uint32_t seed = 16; seed <= 25; ++seed) {
    const Room room = makeRoom (seed);
    for (const Eigen::Isometry3d& pose : drawWalk (room, 12, seed))
      EXPECT_GE (countVisibleSurfaces (room.scene, pose), 3) << seed;
  }
}

TEST (Walk, GoesInSmallStepsAndLooksMostWaysInTheEnd)
{
  const Poses poses = drawWalk (makeRoom (2), 50, 2);
  double turned = 0.0;
  for (std::size_t i = 1; i < poses.size(); ++i) {
    EXPECT_LT (stepOf (poses, i), 0.4);
    EXPECT_LT (degreesBetween (poses[i], poses[i - 1]), 15.0);
    turned += degreesBetween (poses[i], poses[i - 1]);
  }
  EXPECT_GT (turned, 250.0);
}

TEST (Drive, GoesInSmallStepsAboveTheRoad)
{
  const Street street = makeStreet (1);
  const Poses poses = drawDrive (street, 20, 1);
  ASSERT_EQ (poses.size(), 20u);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    EXPECT_NEAR (poses[i].translation().z(), 1.8, 0.11);
    EXPECT_LT (poses[i].translation().head<2>().norm(), 0.25 * street.length + 1.0);
    EXPECT_LT (i > 0 ? stepOf (poses, i) : 0.0, 1.1);
  }
}

TEST (Poses, AreMeasuredAsWellAsAsked)
{
  const Poses truth (2000, Eigen::Isometry3d::Identity());
  EXPECT_TRUE (measured (truth, {}, 1)[7].isApprox (truth[7]));
  double degrees = 0.0, shift = 0.0;
  for (const Eigen::Isometry3d& pose : measured (truth, {3.0, 0.0}, 1)) {
    degrees += std::pow (degreesBetween (pose, truth[0]), 2);
    shift += pose.translation().squaredNorm();
  }
  EXPECT_NEAR (std::sqrt (degrees / 2000), 3.0, 0.15);
  EXPECT_NEAR (std::sqrt (shift / 2000), 0.03, 0.0015);
}

TEST (Poses, DriftFromWhereTheyBegan)
{
  const Poses truth (400, Eigen::Isometry3d::Identity());
  const Poses off = measured (truth, {0.0, 0.1}, 1);
  EXPECT_TRUE (off[0].isApprox (truth[0]));
  EXPECT_LT (degreesBetween (off[1], off[0]), 0.5);
  EXPECT_GT (off[399].translation().norm(), 5.0 * off[1].translation().norm());
}
