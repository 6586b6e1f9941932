// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/types.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <vector>

namespace pcl_ops::internal {

/** \brief Selects the nearest of the points that are added. It collects more points
 * than are wanted, and drops the farthest once there are too many. So adding a point
 * takes constant time on average, however many points are wanted. */
class NearestCandidates {
public:
  /** \brief Returns the bits of a float that is not negative: as integers they have the
   * order of the floats. */
  static std::uint32_t
  bitsOf (float squared_distance)
  {
    std::uint32_t bits;
    std::memcpy (&bits, &squared_distance, sizeof (bits));
    return bits;
  }

  /** \param[in] wanted number of points, 1 or more if any are added
   * \param[in] squared_radius points at this squared distance [m^2] are taken, too: at
   * first the limit is the smallest key of a larger squared distance */
  NearestCandidates (std::size_t wanted, float squared_radius)
  : wanted_ (wanted)
  , shrink_at_ (wanted + std::max (wanted / 2, min_excess))
  , limit_ (keyOf (bitsOf (squared_radius), 0) + (Key (1) << bits_of_index))
  , keys_ (std::min (initial_room, shrink_at_))
  {}

  /** \brief Returns whether points at a squared distance may still be among the
   * nearest. Indices decide between equal squared distances: those of equal points, or
   * those that are 0 or infinite in single precision.
   * \param[in] distance_bits the squared distance by \ref bitsOf
   * \param[in] lowest_index of these points */
  bool
  mayTake (std::uint64_t distance_bits, pcl::index_t lowest_index) const
  {
    return keyOf (distance_bits, lowest_index) < limit_;
  }

  /** \brief Adds \p added points, given by arrays of that length. */
  void
  add (const float* squared_distances, const pcl::index_t* indices, std::size_t added)
  {
    if (keys_.size() < count_ + added)
      keys_.resize (std::max (2 * keys_.size(), count_ + added));
    Key* next = keys_.data() + count_;
    const Key limit = limit_;
    for (std::size_t i = 0; i < added; ++i) {
      const Key key = keyOf (bitsOf (squared_distances[i]), indices[i]);
      // Always written, but counted only if near: no branch to mispredict.
      *next = key;
      next += key < limit ? 1 : 0;
    }
    count_ = static_cast<std::size_t> (next - keys_.data());
    if (count_ >= shrink_at_)
      shrink();
  }

  /** \brief Returns the nearest points.
   * \param[in] sorted true: by distance, then by index; false: in any order */
  void
  take (bool sorted, pcl::Indices& indices, std::vector<float>& squared_distances)
  {
    if (count_ > wanted_)
      shrink();
    if (sorted)
      std::sort (keys_.begin(), keys_.begin() + count_);
    indices.resize (count_);
    squared_distances.resize (count_);
    for (std::size_t i = 0; i < count_; ++i) {
      indices[i] =
          static_cast<pcl::index_t> (keys_[i] & ((Key (1) << bits_of_index) - 1));
      const auto distance_bits = static_cast<std::uint32_t> (keys_[i] >> bits_of_index);
      std::memcpy (&squared_distances[i], &distance_bits, sizeof (distance_bits));
    }
  }

private:
  /** \brief Bits of the squared distance above those of the index: sorts by both. */
  using Key = std::uint64_t;
  static constexpr int bits_of_index = 32;
  /** \brief Points collected beyond the wanted number before some are dropped: half of
   * that number, but at least this many. Both were chosen by hand and change only the
   * time, as does \ref initial_room. */
  static constexpr std::size_t min_excess = 16;
  /** \brief Number of keys for which memory is reserved at first. */
  static constexpr std::size_t initial_room = 128;
  static_assert (sizeof (pcl::index_t) * 8 <= bits_of_index,
                 "an index fits into a key");

  static Key
  keyOf (std::uint64_t distance_bits, pcl::index_t index)
  {
    return distance_bits << bits_of_index | static_cast<Key> (index);
  }

  // Drops all but the nearest wanted_ points.
  void
  shrink ()
  {
    const auto farthest = keys_.begin() + wanted_ - 1;
    std::nth_element (keys_.begin(), farthest, keys_.begin() + count_);
    count_ = wanted_;
    limit_ = *farthest + 1;
  }

  std::size_t wanted_;    // number of points
  std::size_t shrink_at_; // number of points at which all but the wanted are dropped
  /** \brief Only points with keys below this limit are collected. */
  Key limit_;
  /** \brief Number of collected points; \ref keys_ has room for more. */
  std::size_t count_ = 0;
  std::vector<Key> keys_;
};

} // namespace pcl_ops::internal
