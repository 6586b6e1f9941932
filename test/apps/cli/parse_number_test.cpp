// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cli/errors.h>
#include <cli/parse_number.h>
#include <support/text.h>

#include <cstdint>

using namespace pcl_ops::apps;

TEST (ParseNumber, TakesWholeNumbersThatItsTypeCanHaveAndNoLargerOnes)
{
  EXPECT_EQ (parseNumber<std::size_t> ("n", "9223372036854775808", from (1)),
             9223372036854775808U)
      << "2^63, above the largest signed number";
  EXPECT_EQ (parseNumber<std::uint32_t> ("n", "4294967295", from (1)),
             std::numeric_limits<std::uint32_t>::max());
  EXPECT_EQ (parseNumber<int> ("n", "-2147483648", Range()),
             std::numeric_limits<int>::lowest());
  EXPECT_THROW (parseNumber<int> ("n", "2147483648", Range()), UsageError);
}

TEST (ParseNumber, NamesTheLargestNumberOfTheTypeOnlyIfANumberIsLarger)
{
  const auto complaintAbout = [] (const auto& parse, const std::string& text) {
    return complaintOf ([&] { parse ("n", text, from (0)); });
  };
  const auto& parse_32_bits = parseNumber<std::uint32_t>;
  const auto& parse_64_bits = parseNumber<std::uint64_t>;
  EXPECT_EQ (complaintAbout (parse_32_bits, "4294967296"),
             "n: 4294967296 is out of range; give a whole number from 0 up to "
             "4294967295");
  EXPECT_EQ (complaintAbout (parse_64_bits, "99999999999999999999"),
             "n: 99999999999999999999 is out of range; give a whole number from 0 up "
             "to 1.844674407e+19");
  EXPECT_EQ (complaintAbout (parse_32_bits, "-1"),
             "n: -1 is out of range; give a whole number from 0 on");
}
