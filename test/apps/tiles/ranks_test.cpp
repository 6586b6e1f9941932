// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <tiles/ranks.h>

namespace {

using namespace pcl_ops::apps;
using Parts = std::vector<std::size_t>;

} // namespace

TEST (Ranks, AreOneWhereNobodyStartedMore)
{
  const Ranks ranks;
  EXPECT_EQ (ranks.size(), 1);
  EXPECT_EQ (ranks.rank(), 0);
  ranks.meet();
}

TEST (Ranks, ShareTheWorkEvenlyTheLargestPartsFirst)
{
  const std::vector<std::uint64_t> parts = {1, 6, 2, 3, 4};
  EXPECT_EQ (shareOf (0, 2, parts), (Parts{1, 2})) << "6 and 2";
  EXPECT_EQ (shareOf (1, 2, parts), (Parts{4, 3, 0})) << "4, 3 and 1";
  EXPECT_EQ (shareOf (0, 1, parts), (Parts{1, 4, 3, 2, 0}));
  EXPECT_EQ (shareOf (7, 8, parts), Parts{}) << "more ranks than work";
}
