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
  // generator () % bound would fall into the first third half of the time, and
  // generator () * bound / 2^32 would be a multiple of three half of the time.
  constexpr std::uint32_t third = 1u << 30;
  RandomGenerator generator (seedOfTest());
  int in_first_third = 0, multiples_of_three = 0;
  for (int i = 0; i < 30000; ++i) {
    const std::uint32_t drawn = drawBelow (generator, 3 * third);
    in_first_third += drawn < third;
    multiples_of_three += drawn % 3 == 0;
  }
  EXPECT_NEAR (in_first_third, 10000, 5 * 82);
  EXPECT_NEAR (multiples_of_three, 10000, 5 * 82);
}

TEST (DrawUnit, IsUniformInTheHalfOpenUnitInterval)
{
  RandomGenerator generator (seedOfTest());
  std::array<int, 10> tenth{};
  for (int i = 0; i < 10000; ++i) {
    const double drawn = drawUnit (generator);
    ASSERT_GE (drawn, 0.0);
    ASSERT_LT (drawn, 1.0);
    ++tenth[static_cast<std::size_t> (10.0 * drawn)];
  }
  for (const int count : tenth)
    EXPECT_NEAR (count, 1000, 5 * 30);
}
