// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "search/counting_sort.h"

#include <vector>

using namespace pcl_ops::internal;

namespace {

const std::vector<unsigned> bin_of_item{2, 0, 2, 1, 2};

} // namespace

TEST (CountingSort, FindsWhereEachBinBegins)
{
  std::vector<unsigned> begins (5, 99);
  findBegins (bin_of_item, begins);
  EXPECT_EQ (begins, (std::vector<unsigned>{0, 1, 2, 5, 5})) << "the last bin is empty";
}

TEST (CountingSort, PutsItemsBinAfterBinInTheirOrder)
{
  std::vector<std::size_t> sorted (5);
  forPlaces (bin_of_item,
             std::vector<unsigned>{0, 1, 2},
             [&] (std::size_t item, unsigned place) { sorted[place] = item; });
  EXPECT_EQ (sorted, (std::vector<std::size_t>{1, 3, 0, 2, 4}));
}
