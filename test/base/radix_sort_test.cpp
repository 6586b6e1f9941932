// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "base/radix_sort.h"
#include "base/random.h"

#include <algorithm>

using namespace pcl_ops::internal;

namespace {

/** \brief A key, and its position in the list before the list is sorted. */
struct NumberedKey {
  std::uint64_t key;
  std::size_t position;
};

/** \brief Fails unless radixSort sorts the keys as std::stable_sort does. */
void
expectRadixSorted (const std::vector<std::uint64_t>& keys, unsigned threads)
{
  std::vector<NumberedKey> items;
  for (const std::uint64_t key : keys)
    items.push_back ({key, items.size()});
  std::vector<NumberedKey> expected = items;
  std::stable_sort (
      expected.begin(),
      expected.end(),
      [] (const NumberedKey& a, const NumberedKey& b) { return a.key < b.key; });
  std::vector<NumberedKey> spare (items.size());
  const NumberedKey* const sorted = radixSort (
      threads, items.data(), items.size(), spare.data(), [] (const NumberedKey& item) {
        return item.key;
      });
  const auto areSame = [] (const NumberedKey& a, const NumberedKey& b) {
    return a.key == b.key && a.position == b.position;
  };
  EXPECT_TRUE (std::equal (expected.begin(), expected.end(), sorted, areSame));
}

} // namespace

TEST (RadixSort, KeepsTheOrderOfEqualKeysWithAnyNumberOfThreads)
{
  // Each of 5000 keys comes some 20 times. The shift makes upper bits differ. Three
  // threads get four pieces of up to 32,768 items.
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
    for (const std::uint64_t key : {0ULL, 5ULL << 20}) {
      const std::uint64_t other = key ^ 1ULL << bit;
      expectRadixSorted ({other, key, other, key}, 1);
      expectRadixSorted ({key, other}, 1);
    }
}

TEST (RadixSort, TakesNoItemsAndEqualOnes)
{
  expectRadixSorted ({}, 1);
  expectRadixSorted ({7, 7, 7}, 1);
}
