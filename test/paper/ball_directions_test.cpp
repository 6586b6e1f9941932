// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "paper/ball_directions.h"
#include "scene.h"

using namespace pcl_ops::internal;

namespace {

constexpr int phi_steps = 30; // of 6 degrees, from pole to pole

} // namespace

TEST (BallDirections, HavePatchesOfAboutTheSameAreaAndOnePatchOnEachPole)
{
  constexpr int row_of_south_pole = phi_steps;
  constexpr std::uint32_t north_pole = 0;
  const BallDirections ball (phi_steps);
  for (int row = 1; row < row_of_south_pole; ++row) {
    const double phi = row * pi / phi_steps;
    const double area = // on the unit sphere: height times width of the patch
        ball.phi_step * std::sin (phi) * 2.0 * pi / ball.patchesOfRow (row);
    EXPECT_NEAR (area / (ball.phi_step * ball.phi_step), 1.0, 0.1);
  }
  EXPECT_EQ (ball.patchesOfRow (row_of_south_pole), 1);
  EXPECT_EQ (ball.vectorOf (north_pole), Eigen::Vector3d::UnitZ());
  EXPECT_EQ (ball.around (north_pole).size(), 1u + ball.patchesOfRow (1))
      << "the pole and all patches of the next row";
}

TEST (BallDirections,
      ContainTheirOwnCenterAndHaveAnOppositeAtMostAStepFromTheirNegative)
{
  for (const int phi_num : {4, 7, 30, 80}) { // with and without a row at the equator
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

TEST (BallDirections, RepeatAfterAFullTurnAndContinueBeyondAPoleOnTheOtherSide)
{
  const BallDirections ball (phi_steps);
  constexpr int row = 10;
  constexpr double theta = 0.3; // any azimuth [rad]
  EXPECT_EQ (ball.at (row, theta), ball.at (row, theta + 2.0 * pi));
  EXPECT_EQ (ball.at (row, theta), ball.at (row, theta - 4.0 * pi));
  EXPECT_EQ (ball.patchOfRow (row, -1),
             ball.patchOfRow (row, ball.patchesOfRow (row) - 1));
  EXPECT_EQ (ball.at (-2, theta), ball.at (2, theta + pi));
  EXPECT_EQ (ball.at (phi_steps + 2, theta), ball.at (phi_steps - 2, theta + pi));
}

TEST (BallDirections, HaveANeighborhoodOfTheirSidesAndOfNearDirectionsAlone)
{
  const BallDirections ball (phi_steps);
  // A neighbor is up to one row and 1.5 patches away, sqrt (1 + 1.5^2) = 1.8 steps, and
  // somewhat more where patches are wider than a step.
  const double max_angle = 2.2 * ball.phi_step;
  for (std::uint32_t direction = 0; direction < ball.size(); ++direction) {
    const std::vector<std::uint32_t> around = ball.around (direction); // ascending
    EXPECT_TRUE (std::binary_search (around.begin(), around.end(), direction));
    for (const std::uint32_t side : ball.beside (direction))
      EXPECT_TRUE (std::binary_search (around.begin(), around.end(), side));
    for (const std::uint32_t neighbor : around) {
      const double cosine = ball.vectorOf (neighbor).dot (ball.vectorOf (direction));
      EXPECT_LT (std::acos (std::min (1.0, cosine)), max_angle);
    }
  }
}
