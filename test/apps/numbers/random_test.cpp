// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <numbers/random.h>

#include <array>

using pcl_ops::apps::Random;

TEST (Random, IsTheGeneratorOfTheStandard)
{
  Random random (std::mt19937::default_seed);
  for (int i = 1; i < 10000; ++i)
    random.bits();
  EXPECT_EQ (random.bits(), 4123659995u); // [rand.predef] of the C++ standard
}

TEST (Random, DrawsEveryNumberBelowABoundEquallyOften)
{
  constexpr std::uint32_t bound = 3u << 30; // a quarter of draws is rejected
  Random random (1);
  // Wrong ways to do it: a remainder would favor the first third of the numbers, a
  // multiplication alone would favor multiples of three.
  std::array<int, 3> thirds{}, residues{};
  constexpr int draws = 30000;
  for (int i = 0; i < draws; ++i) {
    const std::uint32_t drawn = random.below (bound);
    ++thirds.at (drawn >> 30);
    ++residues.at (drawn % 3);
  }
  constexpr int tolerance = 400; // five times sqrt (draws * 1/3 * 2/3), the deviation
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR (thirds[i], draws / 3, tolerance);
    EXPECT_NEAR (residues[i], draws / 3, tolerance);
  }
  EXPECT_EQ (random.below (1), 0u);
}

TEST (Random, GaussiansHaveMeanZeroAndVarianceOne)
{
  Random random (1);
  double sum = 0.0, squares = 0.0;
  constexpr int draws = 10000;
  for (int i = 0; i < draws; ++i) {
    const double drawn = random.gaussian();
    sum += drawn;
    squares += drawn * drawn;
  }
  // Five standard deviations of the mean, sqrt (1 / draws), and 3.5 of the variance,
  // sqrt (2 / draws).
  EXPECT_NEAR (sum / draws, 0.0, 0.05);
  EXPECT_NEAR (squares / draws, 1.0, 0.05);
}

TEST (Random, BoxesTakeANumberForEachEdgeThatHasALength)
{
  Random random (1), other (1);
  const Eigen::Vector3d drawn = random.inBox ({1, 2, 3}, {5, 2, 4});
  EXPECT_EQ (drawn.z(), other.between (3, 4));
  EXPECT_EQ (drawn.y(), 2.0);
  EXPECT_EQ (drawn.x(), other.between (1, 5));
  EXPECT_EQ (random.bits(), other.bits());
}
