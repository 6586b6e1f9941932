// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud/all_nearest.h"

#include "base/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <utility>
#include <vector>

namespace pcl_ops::internal {

namespace {

// A sort key: the bits of the squared distance above the index of the point. Keys sort
// by distance, which is never negative, and for equal distances by index.
using Key = std::uint64_t;
constexpr int bits_of_index = 32;

Key
keyOf (float squared_distance, std::uint32_t index)
{
  std::uint32_t bits;
  std::memcpy (&bits, &squared_distance, sizeof bits);
  return static_cast<Key> (bits) << bits_of_index | index;
}

float
squaredDistanceOf (Key key)
{
  const auto bits = static_cast<std::uint32_t> (key >> bits_of_index);
  float squared_distance;
  std::memcpy (&squared_distance, &bits, sizeof bits);
  return squared_distance;
}

/** \brief Sorts keys by a bucket sort, then an insertion sort. Squared distances to
 * points on a surface are nearly uniformly distributed, so that few keys share a
 * bucket.
 */
class KeySort {
public:
  // Sorts keys whose squared distances are at most squared_bound [m^2].
  void
  sort (float squared_bound, std::vector<Key>& keys)
  {
    sortByBucket (squared_bound, keys);
    for (std::size_t i = 1; i < keys.size(); ++i) {
      const Key key = sorted_[i];
      std::size_t slot = i;
      for (; slot > 0 && sorted_[slot - 1] > key; --slot)
        sorted_[slot] = sorted_[slot - 1];
      sorted_[slot] = key;
    }
    keys.swap (sorted_);
  }

private:
  // Writes the keys to sorted_, bucket after bucket.
  void
  sortByBucket (float squared_bound, const std::vector<Key>& keys)
  {
    const float scale = squared_bound > 0.0F ? last_bucket / squared_bound : 0.0F;
    std::array<std::uint32_t, buckets + 1> begin{};
    bucket_of_key_.resize (keys.size());
    for (std::size_t i = 0; i < keys.size(); ++i) {
      // NaN for an infinite squared distance: such a key goes to the last bucket.
      const float scaled = scale * squaredDistanceOf (keys[i]);
      bucket_of_key_[i] = scaled < last_bucket
                              ? static_cast<std::uint32_t> (scaled)
                              : static_cast<std::uint32_t> (last_bucket);
      ++begin[bucket_of_key_[i] + 1];
    }
    for (std::size_t b = 0; b < buckets; ++b)
      begin[b + 1] += begin[b];
    sorted_.resize (keys.size());
    for (std::size_t i = 0; i < keys.size(); ++i)
      sorted_[begin[bucket_of_key_[i]]++] = keys[i];
  }

  static constexpr std::size_t buckets = 64;
  static constexpr float last_bucket = buckets - 1;
  std::vector<std::uint32_t> bucket_of_key_;
  std::vector<Key> sorted_;
};

/** \brief Finds the nearest neighbors of the points of leaves, one leaf at a time. The
 * reach of a point is the distance to the farthest of its neighbors [m]. A position is
 * an index into PointTree::order. The numbers in this class were chosen by hand; they
 * change the time, not the neighbors. */
class LeafSearch {
public:
  LeafSearch (const PointTree& tree, std::size_t neighbors, Indices& nearest)
  : tree_ (tree), neighbors_ (neighbors), nearest_ (nearest)
  {}

  // Writes the neighbors of the points of a leaf. Candidates within a first reach of
  // the leaf are tried; the points that need farther ones are tried again with a larger
  // reach.
  void
  find (const PointTree::Leaf& leaf)
  {
    constexpr float growth = 1.5F; // factor from one reach to the next
    unfinished_.clear();
    for (std::uint32_t position = leaf.node->begin; position < leaf.node->end;
         ++position)
      unfinished_.push_back (position);
    float sum_of_reaches = 0.0F;
    for (float reach = firstReach (leaf); !unfinished_.empty(); reach *= growth) {
      const std::size_t candidates =
          tree_.findLeavesAround (*leaf.node, reach, maxCandidates(), ranges_);
      if (candidates > maxCandidates())
        return findOneByOne();
      gather (candidates);
      const bool are_all_points = candidates_.size() == tree_.order().size();
      const float squared_bound =
          are_all_points ? maxSquaredDistance (*leaf.node) : reach * reach;
      const auto findAndTell = [&] (std::uint32_t position) {
        return findNearest (position, squared_bound, sum_of_reaches);
      };
      unfinished_.erase (
          std::remove_if (unfinished_.begin(), unfinished_.end(), findAndTell),
          unfinished_.end());
    }
    mean_reach_ =
        sum_of_reaches / static_cast<float> (leaf.node->end - leaf.node->begin);
  }

private:
  // Returns a little more than the mean reach in the previous leaf, which is enough for
  // most points, but at most the reach of the leaf, which is enough for all.
  float
  firstReach (const PointTree::Leaf& leaf) const
  {
    constexpr float enlargement = 1.15F;
    const float reach = enlargement * mean_reach_;
    // True if points of the previous leaf were equal or so close that squares
    // underflow.
    const bool is_too_small = !(reach * reach > 0.0F);
    return is_too_small ? leaf.reach : std::min (leaf.reach, reach);
  }

  // Largest number of shared candidates of a leaf. A sparse leaf beside a dense region
  // would have more: then the neighbors of its points are searched one by one.
  std::size_t
  maxCandidates () const
  {
    constexpr std::size_t max_candidates_per_neighbor = 32;
    return max_candidates_per_neighbor * (neighbors_ + 1);
  }

  // Searches the tree for the neighbors of each unfinished point.
  void
  findOneByOne ()
  {
    for (const std::uint32_t position : unfinished_) {
      const std::uint32_t own = tree_.order()[position];
      nearest_of_one_.start (neighbors_ + 1);
      tree_.find (position, nearest_of_one_);
      std::uint32_t* next = nearest_.data() + own * neighbors_;
      std::uint32_t* const last = next + neighbors_;
      for (std::size_t i = 0; i < nearest_of_one_.size() && next != last; ++i)
        if (nearest_of_one_[i] != own)
          *next++ = nearest_of_one_[i];
    }
  }

  // Copies the points in ranges_ to the candidates.
  // \param[in] size number of these points
  void
  gather (std::size_t size)
  {
    candidates_.resize (size);
    candidate_indices_.resize (size);
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
      copy (tree_.order(), candidate_indices_);
      next += end - begin;
    }
  }

  // Upper bound of the squared distance from any point of a leaf to any candidate
  // [m^2].
  float
  maxSquaredDistance (const PointTree::Node& leaf) const
  {
    float largest = 0.0F;
    for (std::size_t i = 0; i < candidates_.size(); ++i) {
      const std::array<float, 3> candidate{
          candidates_.x[i], candidates_.y[i], candidates_.z[i]};
      float sum = 0.0F;
      for (int axis = 0; axis < 3; ++axis) {
        const float apart = std::max (candidate[axis] - leaf.low[axis],
                                      leaf.high[axis] - candidate[axis]);
        sum += apart * apart;
      }
      largest = std::max (largest, sum);
    }
    return largest;
  }

  // Finds the nearest neighbors of a point among the candidates, and adds its reach to
  // the sum. Returns false if there are too few within squared_bound.
  bool
  findNearest (std::uint32_t position, float squared_bound, float& sum_of_reaches)
  {
    const std::uint32_t own = tree_.order()[position];
    computeSquaredDistances (position);
    keys_.resize (candidates_.size());
    std::size_t found = 0;
    for (std::size_t i = 0; i < candidates_.size(); ++i) {
      keys_[found] = keyOf (squared_distances_[i], candidate_indices_[i]);
      found += squared_distances_[i] <= squared_bound && candidate_indices_[i] != own
                   ? 1
                   : 0;
    }
    if (found < neighbors_)
      return false;
    keys_.resize (found);
    // Beside a denser region there may be many more candidates within the bound than
    // wanted, most of them about as far away. Then only the nearest ones are sorted.
    constexpr std::size_t max_sorted_per_neighbor = 4;
    if (found > max_sorted_per_neighbor * neighbors_) {
      const auto last = keys_.begin() + static_cast<std::ptrdiff_t> (neighbors_ - 1);
      std::nth_element (keys_.begin(), last, keys_.end());
      squared_bound = squaredDistanceOf (*last);
      keys_.resize (neighbors_);
    }
    sort_.sort (squared_bound, keys_);
    for (std::size_t i = 0; i < neighbors_; ++i)
      nearest_[own * neighbors_ + i] = static_cast<std::uint32_t> (keys_[i]);
    sum_of_reaches += std::sqrt (squaredDistanceOf (keys_[neighbors_ - 1]));
    return true;
  }

  void
  computeSquaredDistances (std::uint32_t position)
  {
    const float x = tree_.sorted().x[position];
    const float y = tree_.sorted().y[position];
    const float z = tree_.sorted().z[position];
    squared_distances_.resize (candidates_.size());
    for (std::size_t i = 0; i < squared_distances_.size(); ++i) {
      const float dx = candidates_.x[i] - x;
      const float dy = candidates_.y[i] - y;
      const float dz = candidates_.z[i] - z;
      squared_distances_[i] = dx * dx + dy * dy + dz * dz;
    }
  }

  const PointTree& tree_;
  const std::size_t neighbors_;
  Indices& nearest_;
  /** \brief In the previous leaf [m]; infinite before the first one. */
  float mean_reach_ = std::numeric_limits<float>::infinity();
  Indices unfinished_; // positions of the points of the leaf that have no neighbors yet
  // Buffers, members only to reuse their memory.
  PointTree::Ranges ranges_;
  NearestPoints nearest_of_one_;
  Coordinates candidates_;
  Indices candidate_indices_;
  std::vector<float> squared_distances_; // from one point to the candidates
  std::vector<Key> keys_; // of the candidates that may be neighbors of one point
  KeySort sort_;
};

} // namespace

Indices
findAllNearest (const PointTree& tree, std::size_t neighbors, unsigned threads)
{
  constexpr std::size_t leaves_per_piece = 512; // chosen by hand, changes only the time
  Indices nearest (tree.order().size() * neighbors);
  const std::vector<PointTree::Leaf> leaves = tree.leaves (neighbors + 1);
  parallelFor (threads,
               leaves.size(),
               leaves_per_piece,
               [&] (std::size_t begin, std::size_t end) {
                 LeafSearch search (tree, neighbors, nearest);
                 for (std::size_t leaf = begin; leaf < end; ++leaf)
                   search.find (leaves[leaf]);
               });
  return nearest;
}

} // namespace pcl_ops::internal
