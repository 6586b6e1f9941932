// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "paper/ball_directions.h"
#include "scene.h"

using namespace pcl_ops::internal;

TEST (BallDirections, HaveAboutTheSameAreaAndOnePatchOnEachPole)
{
  constexpr int south_pole = 30; // its row
  const BallDirections ball (south_pole);
  for (int row = 1; row < south_pole; ++row) {
    const double phi = row * pi / south_pole;
    const double area =
        ball.phi_step * std::sin (phi) * 2.0 * pi / ball.patchesOfRow (row);
    EXPECT_NEAR (area / (ball.phi_step * ball.phi_step), 1.0, 0.1);
  }
  EXPECT_EQ (ball.patchesOfRow (south_pole), 1);
  EXPECT_EQ (ball.vectorOf (0), Eigen::Vector3d::UnitZ());
  EXPECT_EQ (ball.around (0).size(), 1u + ball.patchesOfRow (1));
}

TEST (BallDirections, HoldTheirOwnCentersAndHaveAnOppositeThatPointsAway)
{
  for (const int phi_num : {4, 7, 30, 80}) { // even and odd numbers of rows
    const BallDirections ball (phi_num);
    for (std::uint32_t direction = 0; direction < ball.size(); ++direction) {
      ASSERT_EQ (ball.at (ball.row_of[direction], ball.thetaOf (direction)), direction);
      const std::uint32_t opposite = ball.opposite (direction);
      EXPECT_LT (ball.vectorOf (direction).dot (ball.vectorOf (opposite)),
                 -std::cos (ball.phi_step));
      EXPECT_EQ (ball.opposite (opposite), direction);
    }
  }
}

TEST (BallDirections, WrapAroundTheirRowAndGoOnBeyondAPoleHalfATurnAway)
{
  const BallDirections ball (30);
  EXPECT_EQ (ball.at (10, 0.3), ball.at (10, 0.3 + 2.0 * pi));
  EXPECT_EQ (ball.at (10, 0.3), ball.at (10, 0.3 - 4.0 * pi));
  EXPECT_EQ (ball.patchOfRow (10, -1),
             ball.patchOfRow (10, ball.patchesOfRow (10) - 1));
  EXPECT_EQ (ball.at (-2, 1.0), ball.at (2, 1.0 + pi));
  EXPECT_EQ (ball.at (32, 1.0), ball.at (28, 1.0 + pi));
}

TEST (BallDirections, AreSurroundedByTheirSides)
{
  const BallDirections ball (30);
  for (std::uint32_t direction = 0; direction < ball.size(); ++direction) {
    const auto around = ball.around (direction);
    EXPECT_TRUE (std::binary_search (around.begin(), around.end(), direction));
    for (const std::uint32_t side : ball.beside (direction))
      EXPECT_TRUE (std::binary_search (around.begin(), around.end(), side));
    for (const std::uint32_t near : around) {
      const double cosine = ball.vectorOf (near).dot (ball.vectorOf (direction));
      EXPECT_LT (std::acos (std::min (1.0, cosine)), 2.2 * ball.phi_step);
    }
  }
}
