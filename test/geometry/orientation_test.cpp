// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "scene.h"
#include <pcl_ops/orientation.h>

using pcl_ops::Orientation;
using pcl_ops::orientationOf;

namespace {

const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();

/** \brief A normal at an angle from the up axis. */
Eigen::Vector3d
tilted (double angle)
{
  return {std::sin (angle), 0.0, std::cos (angle)};
}

} // namespace

TEST (OrientationOf, NamesAFloorAWallAndARoof)
{
  EXPECT_EQ (orientationOf (tilted (0_deg), up, 7_deg), Orientation::Horizontal);
  EXPECT_EQ (orientationOf (tilted (90_deg), up, 7_deg), Orientation::Vertical);
  EXPECT_EQ (orientationOf (tilted (45_deg), up, 7_deg), Orientation::Other);
}

TEST (OrientationOf, EndsAtTheTolerance)
{
  EXPECT_EQ (orientationOf (tilted (6.9_deg), up, 7_deg), Orientation::Horizontal);
  EXPECT_EQ (orientationOf (tilted (7.1_deg), up, 7_deg), Orientation::Other);
  EXPECT_EQ (orientationOf (tilted (82.9_deg), up, 7_deg), Orientation::Other);
  EXPECT_EQ (orientationOf (tilted (83.1_deg), up, 7_deg), Orientation::Vertical);
}

TEST (OrientationOf, DoesNotDependOnTheSignOfTheNormal)
{
  for (const double angle : {3_deg, 45_deg, 88_deg})
    EXPECT_EQ (orientationOf (tilted (angle), up, 7_deg),
               orientationOf (-tilted (angle), up, 7_deg));
}

TEST (OrientationOf, AcceptsExactAxesWithAToleranceOfZero)
{
  EXPECT_EQ (orientationOf (up, up, 0.0), Orientation::Horizontal);
  EXPECT_EQ (orientationOf (Eigen::Vector3d::UnitX(), up, 0.0), Orientation::Vertical);
}

TEST (OrientationOf, FollowsTheUpAxisOfACamera)
{
  const Eigen::Vector3d camera_up = -Eigen::Vector3d::UnitY();
  EXPECT_EQ (orientationOf (Eigen::Vector3d::UnitY(), camera_up, 7_deg),
             Orientation::Horizontal);
  EXPECT_EQ (orientationOf (Eigen::Vector3d::UnitZ(), camera_up, 7_deg),
             Orientation::Vertical);
}

TEST (OrientationOf, SurvivesANormalLongerThanOneByRounding)
{
  EXPECT_EQ (orientationOf (up * (1.0 + 1e-15), up, 7_deg), Orientation::Horizontal);
}

TEST (Orientation, HasTheNamesOfThePaper)
{
  EXPECT_STREQ (toString (Orientation::Horizontal), "horizontal");
  EXPECT_STREQ (toString (Orientation::Vertical), "vertical");
  EXPECT_STREQ (toString (Orientation::Other), "other");
}
