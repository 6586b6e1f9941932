// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/types.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <vector>

namespace pcl_ops::internal {

/** \brief Selects the nearest of the points that are added. It collects more than are
 * wanted and drops the farthest once there are too many. So a point costs constant
 * time, however many are wanted. */
class NearestCandidates {
public:
  /** \brief Bits of a float from 0 on: as integers they sort like the floats. */
  static std::uint32_t
  bitsOf (float distance)
  {
    std::uint32_t bits;
    std::memcpy (&bits, &distance, sizeof (bits));
    return bits;
  }

  NearestCandidates (std::size_t most, float squared_radius)
  : max_ (most)
  , shrink_at_ (most + std::max (most / 2, min_more))
  , limit_ (keyOf (bitsOf (squared_radius), 0) + (Key (1) << index_bits))
  , keys_ (std::min (usual_room, shrink_at_))
  {}

  /** \brief Whether points at this squared distance, as \ref bitsOf, with this lowest
   * index may still be among the nearest. Indices alone decide between equal distances,
   * as of equal points or where squares are beyond single precision. */
  bool
  mayTake (std::uint64_t squared_distance, pcl::index_t lowest_index) const
  {
    return keyOf (squared_distance, lowest_index) < limit_;
  }

  void
  add (const float* squared_distances, const pcl::index_t* indices, std::size_t number)
  {
    if (keys_.size() < number_ + number)
      keys_.resize (std::max (2 * keys_.size(), number_ + number));
    Key* next = keys_.data() + number_;
    const Key limit = limit_;
    for (std::size_t i = 0; i < number; ++i) {
      const Key key = keyOf (bitsOf (squared_distances[i]), indices[i]);
      // Always written, but counted only if near: no branch to mispredict.
      *next = key;
      next += key < limit ? 1 : 0;
    }
    number_ = static_cast<std::size_t> (next - keys_.data());
    if (number_ >= shrink_at_)
      shrink();
  }

  /** \brief Returns the nearest points, in any order unless \p sorted. */
  void
  take (bool sorted, pcl::Indices& indices, std::vector<float>& squared_distances)
  {
    if (number_ > max_)
      shrink();
    if (sorted)
      std::sort (keys_.begin(), keys_.begin() + number_);
    indices.resize (number_);
    squared_distances.resize (number_);
    for (std::size_t i = 0; i < number_; ++i) {
      indices[i] = static_cast<pcl::index_t> (keys_[i] & ((Key (1) << index_bits) - 1));
      const auto distance = static_cast<std::uint32_t> (keys_[i] >> index_bits);
      std::memcpy (&squared_distances[i], &distance, sizeof (distance));
    }
  }

private:
  /** \brief Squared distance in the upper bits, index in the lower: sorts by both. */
  using Key = std::uint64_t;
  static constexpr int index_bits = 32;
  static constexpr std::size_t min_more = 16;
  static constexpr std::size_t usual_room = 128;
  static_assert (sizeof (pcl::index_t) * 8 <= index_bits, "an index fits into a key");

  static Key
  keyOf (std::uint64_t squared_distance, pcl::index_t index)
  {
    return squared_distance << index_bits | static_cast<Key> (index);
  }

  void
  shrink ()
  {
    const auto farthest = keys_.begin() + max_ - 1;
    std::nth_element (keys_.begin(), farthest, keys_.begin() + number_);
    number_ = max_;
    limit_ = *farthest + 1;
  }

  std::size_t max_;
  std::size_t shrink_at_;
  /** \brief Only points with keys below this limit are collected. */
  Key limit_;
  std::size_t number_ = 0;
  std::vector<Key> keys_;
};

} // namespace pcl_ops::internal
