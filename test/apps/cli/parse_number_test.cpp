// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cli/errors.h>
#include <cli/parse_number.h>

#include <cstdint>

using namespace pcl_ops::apps;

TEST (ParseNumber, TakesWholeNumbersUpToTheLargestOfTheirType)
{
  EXPECT_EQ (parseNumber<std::size_t> ("n", "9223372036854775808", from (1)),
             9223372036854775808U);
  EXPECT_EQ (parseNumber<std::uint32_t> ("n", "4294967295", from (1)),
             std::numeric_limits<std::uint32_t>::max());
  EXPECT_EQ (parseNumber<int> ("n", "-2147483648", Range()),
             std::numeric_limits<int>::lowest());
  EXPECT_THROW (parseNumber<int> ("n", "2147483648", Range()), UsageError);
}
