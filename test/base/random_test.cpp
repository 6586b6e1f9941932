// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scene.h"

#include <array>

using namespace pcl_ops::internal;

TEST (DrawBelow, StaysBelowItsBoundOrIsZero)
{
  RandomGenerator generator (seedOfTest());
  for (const std::uint32_t bound : {0u, 1u, 2u, 3u, 1000u, 0x80000001u, 0xffffffffu})
    for (int i = 0; i < 1000; ++i)
      EXPECT_LT (drawBelow (generator, bound), std::max (1u, bound));
}

TEST (DrawBelow, IsUnbiasedWhereAModuloOrAProductAloneWouldNotBe)
{
  // The bound is 3 * 2^30. Of all numbers generator () % bound, one half would be below
  // a third of the bound, and of all numbers generator () * bound / 2^32, one half
  // would be multiples of three; one third is right.
  constexpr std::uint32_t third = 1u << 30;
  constexpr int draws = 30000;
  constexpr int standard_deviation = 82; // of both counts: sqrt (draws * 1/3 * 2/3)
  RandomGenerator generator (seedOfTest());
  int in_first_third = 0, multiples_of_three = 0;
  for (int i = 0; i < draws; ++i) {
    const std::uint32_t drawn = drawBelow (generator, 3 * third);
    in_first_third += drawn < third;
    multiples_of_three += drawn % 3 == 0;
  }
  EXPECT_NEAR (in_first_third, draws / 3, 5 * standard_deviation);
  EXPECT_NEAR (multiples_of_three, draws / 3, 5 * standard_deviation);
}

TEST (DrawUnit, IsUniformInTheHalfOpenUnitInterval)
{
  RandomGenerator generator (seedOfTest());
  constexpr int draws = 10000;
  constexpr int standard_deviation = 30; // of each count: sqrt (draws * 1/10 * 9/10)
  std::array<int, 10> draws_in_tenth{};
  for (int i = 0; i < draws; ++i) {
    const double drawn = drawUnit (generator);
    ASSERT_GE (drawn, 0.0);
    ASSERT_LT (drawn, 1.0);
    ++draws_in_tenth[static_cast<std::size_t> (10.0 * drawn)];
  }
  for (const int count : draws_in_tenth)
    EXPECT_NEAR (count, draws / 10, 5 * standard_deviation);
}
