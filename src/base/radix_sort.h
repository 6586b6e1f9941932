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

/** \brief Bits of a digit of a key: its counts, 2^11 of 4 bytes, fit the fastest cache.
 */
inline constexpr int bits_of_digit = 11;

/** \brief Sorts items by one digit of their keys; those that agree stay in their order.
 * Other parameters are those of \ref radixSort.
 * \param[in] lowest_bit of the digit
 * \param[out] sorted room for as many items */
template <typename Item, typename KeyOf>
void
sortByDigit (unsigned threads,
             const Item* items,
             std::size_t size,
             int lowest_bit,
             const KeyOf& keyOf,
             Item* sorted)
{
  constexpr std::size_t digits = 1 << bits_of_digit;
  constexpr std::size_t items_per_piece = 1 << 15; // much more than there are digits
  const auto digitOf = [&] (const Item& item) {
    return static_cast<std::size_t> (keyOf (item) >> lowest_bit & (digits - 1));
  };
  // For each piece of the items: how many have each digit.
  using PerDigit = std::array<std::uint32_t, digits>;
  std::vector<PerDigit> per_piece =
      parallelChunks (threads, size, items_per_piece, [&] (auto begin, auto end) {
        PerDigit counts{};
        for (std::size_t i = begin; i < end; ++i)
          ++counts[digitOf (items[i])];
        return counts;
      });
  // In place of each count, where its items begin in the sorted ones.
  std::uint32_t next = 0;
  for (std::size_t digit = 0; digit < digits; ++digit)
    for (PerDigit& of_piece : per_piece) {
      const std::uint32_t count = of_piece[digit];
      of_piece[digit] = next;
      next += count;
    }
  parallelFor (threads, size, items_per_piece, [&] (auto begin, auto end) {
    PerDigit& positions = per_piece[begin / items_per_piece];
    for (std::size_t i = begin; i < end; ++i)
      sorted[positions[digitOf (items[i])]++] = items[i];
  });
}

/** \brief Sorts items by rising keys, digit by digit from the lowest; those of one key
 * stay in their order. Ends at the highest digit in which keys differ.
 * \param[in,out] items they are overwritten
 * \param[in] size fewer than 2^32
 * \param[in] spare room for as many items
 * \param[in] keyOf returns the key of an item, 64 bits without a sign
 * \return the sorted items: \p items or \p spare */
template <typename Item, typename KeyOf>
Item*
radixSort (
    unsigned threads, Item* items, std::size_t size, Item* spare, const KeyOf& keyOf)
{
  std::uint64_t differing = 0;
  for (std::size_t i = 0; i < size; ++i)
    differing |= keyOf (items[i]) ^ keyOf (items[0]);
  for (int bit = 0; bit < 64 && differing >> bit != 0; bit += bits_of_digit) {
    sortByDigit (threads, items, size, bit, keyOf, spare);
    std::swap (items, spare);
  }
  return items;
}

} // namespace pcl_ops::internal
