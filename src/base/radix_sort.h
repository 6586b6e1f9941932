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

/** \brief Sorts items by 11 bits of their keys; those that agree stay in their order.
 * The rest as \ref radixSort. */
template <typename Item, typename KeyOf>
void
sortByDigit (unsigned threads,
             const Item* items,
             std::size_t size,
             int lowest_bit,
             const KeyOf& keyOf,
             Item* sorted)
{
  constexpr std::size_t digits = 1 << 11;
  constexpr std::size_t items_per_piece = 1 << 15;
  const auto digitOf = [&] (const Item& item) {
    return static_cast<std::size_t> (keyOf (item) >> lowest_bit & (digits - 1));
  };
  // Of each piece how many have a digit, then where they go.
  using Places = std::array<std::uint32_t, digits>;
  std::vector<Places> places =
      parallelChunks (threads, size, items_per_piece, [&] (auto begin, auto end) {
        Places number{};
        for (std::size_t i = begin; i < end; ++i)
          ++number[digitOf (items[i])];
        return number;
      });
  std::uint32_t next = 0;
  for (std::size_t digit = 0; digit < digits; ++digit)
    for (Places& place : places) {
      const std::uint32_t number = place[digit];
      place[digit] = next;
      next += number;
    }
  parallelFor (threads, size, items_per_piece, [&] (auto begin, auto end) {
    Places& place = places[begin / items_per_piece];
    for (std::size_t i = begin; i < end; ++i)
      sorted[place[digitOf (items[i])]++] = items[i];
  });
}

/** \brief Sorts items by their keys, the lowest digits first; those of one key stay in
 * their order. Digits in which no keys differ are left out.
 * \param[in] size fewer than 2^32
 * \param[in] spare room for as many
 * \param[in] keyOf returns the key of an item, 64 bits without a sign
 * \return where they are sorted: one of the two places */
template <typename Item, typename KeyOf>
Item*
radixSort (
    unsigned threads, Item* items, std::size_t size, Item* spare, const KeyOf& keyOf)
{
  std::uint64_t differing = 0;
  for (std::size_t i = 0; i < size; ++i)
    differing |= keyOf (items[i]) ^ keyOf (items[0]);
  for (int bit = 0; bit < 64 && differing >> bit != 0; bit += 11) {
    sortByDigit (threads, items, size, bit, keyOf, spare);
    std::swap (items, spare);
  }
  return items;
}

} // namespace pcl_ops::internal
