// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "base/radix_sort.h"
#include "base/random.h"

#include <algorithm>

using namespace pcl_ops::internal;

namespace {

/** \brief A key, and its position before it was sorted. */
using NumberedKey = std::pair<std::uint64_t, std::size_t>;

void
expectRadixSorted (const std::vector<std::uint64_t>& keys, unsigned threads)
{
  std::vector<NumberedKey> items;
  for (const std::uint64_t key : keys)
    items.emplace_back (key, items.size());
  std::vector<NumberedKey> expected = items;
  std::stable_sort (
      expected.begin(),
      expected.end(),
      [] (const NumberedKey& a, const NumberedKey& b) { return a.first < b.first; });
  std::vector<NumberedKey> spare (items.size());
  const NumberedKey* const sorted =
      radixSort (threads, items.data(), items.size(), spare.data(), [] (const auto& a) {
        return a.first;
      });
  EXPECT_TRUE (std::equal (expected.begin(), expected.end(), sorted));
}

} // namespace

TEST (RadixSort, KeepsTheOrderOfEqualKeysWithAnyNumberOfThreads)
{
  RandomGenerator generator (1);
  std::vector<std::uint64_t> keys;
  for (int i = 0; i < 100'000; ++i)
    keys.push_back (std::uint64_t (drawBelow (generator, 5000)) << 30);
  for (const unsigned threads : {1u, 3u})
    expectRadixSorted (keys, threads);
}

TEST (RadixSort, TellsKeysApartThatDifferInOneBitAnywhere)
{
  for (int bit = 0; bit < 64; ++bit)
    for (const std::uint64_t same : {0ULL, 5ULL << 20}) {
      const std::uint64_t other = same ^ 1ULL << bit;
      expectRadixSorted ({other, same, other, same}, 1);
      expectRadixSorted ({same, other}, 1);
    }
}

TEST (RadixSort, TakesNoItemsAndEqualOnes)
{
  expectRadixSorted ({}, 1);
  expectRadixSorted ({7, 7, 7}, 1);
}
