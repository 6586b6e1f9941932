// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cell_tree_limits.h"
#include "nearest_candidates.h"
#include <pcl_ops/cell_tree.h>

#include <algorithm>
#include <array>

namespace pcl_ops {

namespace {

/** \brief What is still to be visited, the next one on top: in one number the distance,
 * as sorting goes by it, and which child of which node it is. */
class Postponed {
public:
  bool
  empty () const
  {
    return number_ == 0;
  }

  /** \brief Later additions come before earlier ones, nearer before farther ones. */
  void
  startNode ()
  {
    first_of_node_ = number_;
  }

  void
  add (float squared_distance, std::uint32_t child)
  {
    const Entry entry =
        (Entry (NearestCandidates::bitsOf (squared_distance)) << child_bits) | child;
    std::size_t place = number_++;
    for (; place > first_of_node_ && entries_[place - 1] < entry; --place)
      entries_[place] = entries_[place - 1];
    entries_[place] = entry;
  }

  std::uint64_t
  pop ()
  {
    return entries_[--number_];
  }

  static constexpr int child_bits = 32;

private:
  using Entry = std::uint64_t;
  // Dividing by 4 / 3 or more leaves one of 2^32 cells after 78 times, one point of a
  // cell after as many; a level of nodes divides three times.
  static constexpr std::size_t most_levels = 2 * (78 / 3);
  std::array<Entry, most_levels * 8> entries_;
  std::size_t number_ = 0;
  std::size_t first_of_node_ = 0;
};

} // namespace

// Rounded as the distances of points are, it is never more than theirs.
void
CellTree::squaredDistances (const Node& node,
                            const Eigen::Vector3f& position,
                            OfChildren& distances)
{
  using Values = Eigen::Array<float, most_children, 1>;
  const auto outside = [] (const OfChildren& low, float value, const OfChildren& high) {
    const Eigen::Map<const Values> l (low.data()), h (high.data());
    return (l - value).max (value - h).max (0.0f).square().eval();
  };
  Eigen::Map<Values> (distances.data()) =
      outside (node.low_x, position.x(), node.high_x) +
      outside (node.low_y, position.y(), node.high_y) +
      outside (node.low_z, position.z(), node.high_z);
}

void
CellTree::visitLeaf (const Child& leaf,
                     const Eigen::Vector3f& position,
                     NearestCandidates& candidates) const
{
  std::array<float, most_points_of_leaf> distances;
  const float x = position.x(), y = position.y(), z = position.z();
  const float* const px = points_.x.data() + leaf.first;
  const float* const py = points_.y.data() + leaf.first;
  const float* const pz = points_.z.data() + leaf.first;
  for (std::uint32_t i = 0; i < leaf.size; ++i) {
    const float dx = px[i] - x, dy = py[i] - y, dz = pz[i] - z;
    distances[i] = dx * dx + dy * dy + dz * dz;
  }
  candidates.add (distances.data(), &index_[leaf.first], leaf.size);
}

void
CellTree::visit (const Eigen::Vector3f& position, NearestCandidates& candidates) const
{
  Postponed postponed;
  OfChildren distances;
  std::uint32_t number = 0;
  while (true) {
    const Node& node = nodes_[number];
    squaredDistances (node, position, distances);
    postponed.startNode();
    for (std::uint32_t i = 0; i < node.number; ++i)
      if (candidates.mayTake (distances[i]))
        postponed.add (distances[i], number * most_children + i);
    for (bool is_leaf = true; is_leaf;) {
      if (postponed.empty())
        return;
      const std::uint64_t next = postponed.pop();
      if (!candidates.mayTakeBits (next >> Postponed::child_bits))
        continue;
      const auto slot = static_cast<std::uint32_t> (next);
      const Child& child = nodes_[slot / most_children].children[slot % most_children];
      is_leaf = child.size > 0;
      if (is_leaf)
        visitLeaf (child, position, candidates);
      else
        number = child.first;
    }
  }
}

void
CellTree::find (const NeighbourQuery& query,
                pcl::Indices& indices,
                std::vector<float>& squared_distances) const
{
  NearestCandidates candidates (std::min (query.most, size()), query.squared_radius);
  if (size() > 0 && query.most > 0)
    visit (query.position, candidates);
  candidates.take (query.sorted, indices, squared_distances);
}

} // namespace pcl_ops
