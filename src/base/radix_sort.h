// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/parallel.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace pcl_ops::internal {

/** \brief Number of bits of one digit of a key: the 2^11 counters of 4 bytes fit into
 * the L1 cache. */
inline constexpr int bits_of_digit = 11;

/** \brief Sorts items by one digit of their keys; the sort is stable. See
 * \ref radixSort for the other parameters.
 * \param[in] lowest_bit position of the lowest bit of the digit in the key
 * \param[out] sorted gets the sorted items; has room for \p size items */
template <typename Item, typename KeyOf>
void
sortByDigit (unsigned threads,
             const Item* items,
             std::size_t size,
             int lowest_bit,
             const KeyOf& keyOf,
             Item* sorted)
{
  constexpr std::size_t digits = 1 << bits_of_digit; // number of values of a digit
  // Many more than there are digits: the counters of a piece cost little per item.
  constexpr std::size_t items_per_piece = 1 << 15;
  const auto digitOf = [&] (const Item& item) {
    return static_cast<std::size_t> (keyOf (item) >> lowest_bit & (digits - 1));
  };
  // The histogram of the digit for each piece of the items.
  using PerDigit = std::array<std::uint32_t, digits>;
  std::vector<PerDigit> per_piece = parallelPieces (
      threads, size, items_per_piece, [&] (std::size_t begin, std::size_t end) {
        PerDigit counts{};
        for (std::size_t i = begin; i < end; ++i)
          ++counts[digitOf (items[i])];
        return counts;
      });
  // Replace each count by the index in sorted where the counted items begin.
  std::uint32_t next = 0;
  for (std::size_t digit = 0; digit < digits; ++digit)
    for (PerDigit& of_piece : per_piece) {
      const std::uint32_t count = of_piece[digit];
      of_piece[digit] = next;
      next += count;
    }
  parallelFor (
      threads, size, items_per_piece, [&] (std::size_t begin, std::size_t end) {
        PerDigit& next_of_digit = per_piece[begin / items_per_piece];
        for (std::size_t i = begin; i < end; ++i)
          sorted[next_of_digit[digitOf (items[i])]++] = items[i];
      });
}

/** \brief Sorts items by ascending key: a stable radix sort, from the lowest digit to
 * the highest one in which keys differ.
 * \param[in,out] items the items to sort; overwritten
 * \param[in] size number of items, below 2^32
 * \param[in] spare buffer with room for \p size items; overwritten
 * \param[in] keyOf returns the key of an item, an unsigned integer of 64 bits
 * \return the buffer that holds the sorted items: \p items or \p spare */
template <typename Item, typename KeyOf>
Item*
radixSort (
    unsigned threads, Item* items, std::size_t size, Item* spare, const KeyOf& keyOf)
{
  constexpr int bits_of_key = 64;
  std::uint64_t differing_bits = 0;
  for (std::size_t i = 0; i < size; ++i)
    differing_bits |= keyOf (items[i]) ^ keyOf (items[0]);
  for (int lowest_bit = 0;
       lowest_bit < bits_of_key && differing_bits >> lowest_bit != 0;
       lowest_bit += bits_of_digit) {
    sortByDigit (threads, items, size, lowest_bit, keyOf, spare);
    std::swap (items, spare); // the sorted items are the input of the next digit
  }
  return items;
}

} // namespace pcl_ops::internal
