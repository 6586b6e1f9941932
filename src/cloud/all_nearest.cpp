// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud/all_nearest.h"

#include "base/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <utility>

namespace pcl_ops::internal {

namespace {

// Sort key: the bits of the squared distance above the index of the point. Keys sort by
// distance, which is never negative, and for equal distances by index.
std::uint64_t
keyOf (float squared_distance, std::uint32_t number)
{
  std::uint32_t bits;
  std::memcpy (&bits, &squared_distance, sizeof bits);
  constexpr int bits_of_number = 32;
  return static_cast<std::uint64_t> (bits) << bits_of_number | number;
}

float
squaredDistanceOf (std::uint64_t key)
{
  constexpr int bits_of_number = 32;
  const auto bits = static_cast<std::uint32_t> (key >> bits_of_number);
  float squared_distance;
  std::memcpy (&squared_distance, &bits, sizeof bits);
  return squared_distance;
}

/** \brief Sorts keys by a bucket sort, then an insertion sort. Squared distances to
 * points on a surface are nearly uniform, so that few keys share a bucket. */
class KeySort {
public:
  // Sorts keys of squared distances up to bound.
  void
  sort (float bound, std::vector<std::uint64_t>& keys)
  {
    const float scale = bound > 0.0F ? last_bin / bound : 0.0F;
    std::array<std::uint32_t, bins + 1> begin{};
    bin_.resize (keys.size());
    for (std::size_t i = 0; i < keys.size(); ++i) {
      // An infinite squared distance makes the place NaN; it goes to the last bin.
      const float place = scale * squaredDistanceOf (keys[i]);
      bin_[i] = place < last_bin ? static_cast<std::uint32_t> (place)
                                 : static_cast<std::uint32_t> (last_bin);
      ++begin[bin_[i] + 1];
    }
    for (std::size_t b = 0; b < bins; ++b)
      begin[b + 1] += begin[b];
    sorted_.resize (keys.size());
    for (std::size_t i = 0; i < keys.size(); ++i)
      sorted_[begin[bin_[i]]++] = keys[i];
    for (std::size_t i = 1; i < keys.size(); ++i) {
      const std::uint64_t key = sorted_[i];
      std::size_t place = i;
      for (; place > 0 && sorted_[place - 1] > key; --place)
        sorted_[place] = sorted_[place - 1];
      sorted_[place] = key;
    }
    keys.swap (sorted_);
  }

private:
  static constexpr std::size_t bins = 64;
  static constexpr float last_bin = bins - 1;
  std::vector<std::uint32_t> bin_;
  std::vector<std::uint64_t> sorted_;
};

/** \brief Finds the nearest neighbors of the points of leaves, one leaf at a time. */
class LeafSearch {
public:
  LeafSearch (const PointTree& tree, std::size_t number, Indices& nearest)
  : tree_ (tree), number_ (number), nearest_ (nearest)
  {}

  void
  find (const PointTree::Leaf& leaf)
  {
    open_.clear();
    for (std::uint32_t p = leaf.node->begin; p < leaf.node->end; ++p)
      open_.push_back (p);
    // Mean distance to the last neighbor in the previous leaf: right for most points.
    constexpr float spare = 1.15F;
    constexpr float growth = 1.5F;
    float reach = spare * usual_reach_;
    // The previous leaf had equal points, or points so close that squares underflow.
    if (!(reach * reach > 0.0F))
      reach = leaf.reach;
    reach = std::min (leaf.reach, reach);
    float sum = 0.0F;
    for (; !open_.empty(); reach *= growth) {
      const std::size_t candidates =
          tree_.findLeavesAround (*leaf.node, reach, maxCandidates(), ranges_);
      if (candidates > maxCandidates())
        return findOneByOne();
      gather (candidates);
      const bool has_all = candidates_.size() == tree_.order().size();
      const float bound = has_all ? farthest (*leaf.node) : reach * reach;
      const auto isFound = [&] (std::uint32_t position) {
        return findNearest (position, bound, sum);
      };
      open_.erase (std::remove_if (open_.begin(), open_.end(), isFound), open_.end());
    }
    usual_reach_ = sum / static_cast<float> (leaf.node->end - leaf.node->begin);
  }

private:
  // Largest number of shared candidates of a leaf. A sparse leaf beside a dense region
  // would have more; its points are searched one by one.
  std::size_t
  maxCandidates () const
  {
    constexpr std::size_t for_each = 32;
    return for_each * (number_ + 1);
  }

  void
  findOneByOne ()
  {
    for (const std::uint32_t position : open_) {
      const std::uint32_t own = tree_.order()[position];
      one_.start (number_ + 1);
      tree_.find (position, one_);
      std::uint32_t* next = nearest_.data() + own * number_;
      std::uint32_t* const last = next + number_;
      for (std::size_t i = 0; i < one_.size() && next != last; ++i)
        if (one_[i] != own)
          *next++ = one_[i];
    }
  }

  void
  gather (std::size_t size)
  {
    candidates_.resize (size);
    numbers_.resize (size);
    const Coordinates& sorted = tree_.sorted();
    std::size_t next = 0;
    for (const auto& [begin, end] : ranges_) {
      const auto copy = [begin = begin, end = end, next] (const auto& from, auto& to) {
        std::copy (from.begin() + begin,
                   from.begin() + end,
                   to.begin() + static_cast<std::ptrdiff_t> (next));
      };
      copy (sorted.x, candidates_.x);
      copy (sorted.y, candidates_.y);
      copy (sorted.z, candidates_.z);
      copy (tree_.order(), numbers_);
      next += end - begin;
    }
  }

  // Upper bound of the squared distance from any point of a leaf to any candidate.
  float
  farthest (const PointTree::Node& leaf) const
  {
    float most = 0.0F;
    for (std::size_t i = 0; i < candidates_.size(); ++i) {
      const std::array<float, 3> at{
          candidates_.x[i], candidates_.y[i], candidates_.z[i]};
      float sum = 0.0F;
      for (int axis = 0; axis < 3; ++axis) {
        const float apart =
            std::max (at[axis] - leaf.low[axis], leaf.high[axis] - at[axis]);
        sum += apart * apart;
      }
      most = std::max (most, sum);
    }
    return most;
  }

  // Finds the nearest neighbors of a point among the candidates; false if there are too
  // few within the squared distance bound.
  bool
  findNearest (std::uint32_t position, float bound, float& sum_of_reaches)
  {
    const std::uint32_t own = tree_.order()[position];
    measure (position);
    keys_.resize (candidates_.size());
    std::size_t found = 0;
    for (std::size_t i = 0; i < candidates_.size(); ++i) {
      keys_[found] = keyOf (squared_[i], numbers_[i]);
      found += squared_[i] <= bound && numbers_[i] != own ? 1 : 0;
    }
    if (found < number_)
      return false;
    keys_.resize (found);
    // Beside a denser region there may be many more candidates than wanted, all about
    // as far away. Then only the nearest ones are sorted.
    constexpr std::size_t few = 4;
    if (found > few * number_) {
      const auto last = keys_.begin() + static_cast<std::ptrdiff_t> (number_ - 1);
      std::nth_element (keys_.begin(), last, keys_.end());
      bound = squaredDistanceOf (*last);
      keys_.resize (number_);
    }
    sort_.sort (bound, keys_);
    for (std::size_t i = 0; i < number_; ++i)
      nearest_[own * number_ + i] = static_cast<std::uint32_t> (keys_[i]);
    sum_of_reaches += std::sqrt (squaredDistanceOf (keys_[number_ - 1]));
    return true;
  }

  void
  measure (std::uint32_t position)
  {
    const float x = tree_.sorted().x[position];
    const float y = tree_.sorted().y[position];
    const float z = tree_.sorted().z[position];
    squared_.resize (candidates_.size());
    for (std::size_t i = 0; i < squared_.size(); ++i) {
      const float dx = candidates_.x[i] - x;
      const float dy = candidates_.y[i] - y;
      const float dz = candidates_.z[i] - z;
      squared_[i] = dx * dx + dy * dy + dz * dz;
    }
  }

  const PointTree& tree_;
  const std::size_t number_;
  Indices& nearest_;
  float usual_reach_ = std::numeric_limits<float>::infinity();
  Indices open_;
  PointTree::Ranges ranges_;
  NearestPoints one_;
  Coordinates candidates_;
  Indices numbers_;
  std::vector<float> squared_;
  std::vector<std::uint64_t> keys_;
  KeySort sort_;
};

} // namespace

Indices
findAllNearest (const PointTree& tree, std::size_t number, unsigned threads)
{
  constexpr std::size_t leaves_at_once = 512;
  Indices nearest (tree.order().size() * number);
  const std::vector<PointTree::Leaf> leaves = tree.leaves (number + 1);
  parallelFor (
      threads, leaves.size(), leaves_at_once, [&] (std::size_t begin, std::size_t end) {
        LeafSearch search (tree, number, nearest);
        for (std::size_t l = begin; l < end; ++l)
          search.find (leaves[l]);
      });
  return nearest;
}

} // namespace pcl_ops::internal
