// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud/box_tree.h"

#include <Eigen/Geometry>

#include "cloud/nearest_candidates.h"

#include <algorithm>
#include <array>
#include <limits>

namespace pcl_ops::internal {
namespace {

using Node = BoxTree::Node;
using Child = BoxTree::Child;

using Distances = Eigen::Array<float, BoxTree::max_children, 1>;

// Squared distances to the boxes of the children. The rounding is that of the distances
// of points, so no point in a box is nearer than the box.
Distances
squaredDistances (const Node& node, const Eigen::Vector3f& position)
{
  const auto outside = [&] (Eigen::Index axis) {
    const float value = position[axis];
    return (node.low.col (axis) - value)
        .max (value - node.high.col (axis))
        .max (0.0f)
        .square()
        .eval();
  };
  return outside (0) + outside (1) + outside (2);
}

void
visitLeaf (const Child& leaf,
           const Coordinates& points,
           const pcl::Indices& index,
           const Eigen::Vector3f& position,
           NearestCandidates& candidates)
{
  std::array<float, BoxTree::max_points_of_leaf> distances;
  const float x = position.x();
  const float y = position.y();
  const float z = position.z();
  const float* const px = points.x.data() + leaf.first;
  const float* const py = points.y.data() + leaf.first;
  const float* const pz = points.z.data() + leaf.first;
  for (std::uint32_t i = 0; i < leaf.size; ++i) {
    const float dx = px[i] - x;
    const float dy = py[i] - y;
    const float dz = pz[i] - z;
    distances[i] = dx * dx + dy * dy + dz * dz;
  }
  candidates.add (distances.data(), &index[leaf.first], leaf.size);
}

/** \brief Stack of children still to be visited, the next one on top. The upper bits
 * are the squared distance, to sort by it; the lower node * max_children + child. */
struct Postponed {
  static constexpr int child_bits = 32;
  // Each division leaves at most 3/4 of the points on a side, so one of 2^32 points is
  // left after 78 divisions. A level of nodes makes three divisions.
  static constexpr std::size_t max_levels = 78 / 3;

  std::array<std::uint64_t, max_levels * BoxTree::max_children> children;
  std::size_t number = 0;
};

// Pushes the children of a node on top of the stack, the nearest one topmost.
void
postponeChildren (const std::vector<Node>& nodes,
                  std::uint32_t number,
                  const Eigen::Vector3f& position,
                  const NearestCandidates& candidates,
                  Postponed& postponed)
{
  const Node& node = nodes[number];
  const Distances distances = squaredDistances (node, position);
  const std::size_t first = postponed.number;
  for (std::uint32_t i = 0; i < node.number; ++i) {
    const std::uint64_t distance = NearestCandidates::bitsOf (distances[i]);
    if (!candidates.mayTake (distance, node.lowest_index[i]))
      continue;
    const std::uint64_t child =
        distance << Postponed::child_bits | (number * BoxTree::max_children + i);
    std::size_t place = postponed.number++;
    for (; place > first && postponed.children[place - 1] < child; --place)
      postponed.children[place] = postponed.children[place - 1];
    postponed.children[place] = child;
  }
}

/** \brief A point with its index in the cloud. */
struct Item {
  Eigen::Vector3f position;
  pcl::index_t index;
};

/** \brief A range of items with its bounding box. */
struct Range {
  Item* begin;
  Item* end;
  Eigen::AlignedBox3f box;
  pcl::index_t lowest_index = std::numeric_limits<pcl::index_t>::max();

  Range (Item* first, Item* last) : begin (first), end (last)
  {
    for (const Item* item = begin; item != end; ++item) {
      box.extend (item->position);
      lowest_index = std::min (lowest_index, item->index);
    }
  }

  bool
  isLeaf () const
  {
    return end - begin <= std::ptrdiff_t (BoxTree::max_points_of_leaf);
  }
};

// Divides items at the middle of the longest side of their box, which makes compact
// boxes; at the median if one side would get less than a quarter of the items.
Item*
divide (const Range& items)
{
  Eigen::Index side = 0;
  items.box.sizes().maxCoeff (&side);
  const float center = items.box.center()[side];
  Item* const middle = std::partition (items.begin, items.end, [=] (const Item& item) {
    return item.position[side] < center;
  });
  const std::ptrdiff_t size = items.end - items.begin;
  constexpr std::ptrdiff_t min_share = 4;
  if (min_share * std::min (middle - items.begin, items.end - middle) >= size)
    return middle;
  // Equal coordinates are sorted by index: a search among equal points can stop early.
  Item* const median = items.begin + size / 2;
  std::nth_element (
      items.begin, median, items.end, [=] (const Item& first, const Item& second) {
        const float a = first.position[side];
        const float b = second.position[side];
        return a != b ? a < b : first.index < second.index;
      });
  return median;
}

std::vector<Range>
split (const Range& items)
{
  std::vector<Range> ranges{items};
  std::vector<Range> halves;
  for (std::size_t most = 2; most <= BoxTree::max_children; most *= 2) {
    halves.clear();
    for (const Range& range : ranges)
      if (range.isLeaf())
        halves.push_back (range);
      else {
        Item* const middle = divide (range);
        halves.emplace_back (range.begin, middle);
        halves.emplace_back (middle, range.end);
      }
    ranges.swap (halves);
  }
  return ranges;
}

// Adds a node over items and the nodes below it; returns its index. Reorders the items
// leaf by leaf.
std::uint32_t
grow (const Item* first, const Range& items, std::vector<Node>& nodes)
{
  const auto number = static_cast<std::uint32_t> (nodes.size());
  nodes.emplace_back();
  for (const Range& range : split (items)) {
    const auto begin = static_cast<std::uint32_t> (range.begin - first);
    const auto size = static_cast<std::uint32_t> (range.end - range.begin);
    const Child child =
        range.isLeaf() ? Child{begin, size} : Child{grow (first, range, nodes), 0};
    Node& node = nodes[number];
    const std::uint32_t i = node.number++;
    node.children[i] = child;
    node.lowest_index[i] = range.lowest_index;
    node.low.row (i) = range.box.min().transpose();
    node.high.row (i) = range.box.max().transpose();
  }
  return number;
}

} // namespace

BoxTree::BoxTree (const Points& points, const CloudView& cloud)
{
  std::vector<Item> items;
  items.reserve (points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const pcl::index_t index = points.indexOf (i);
    const float* const position = cloud[index];
    items.push_back ({{position[0], position[1], position[2]}, index});
  }
  if (!items.empty())
    grow (items.data(), {items.data(), items.data() + items.size()}, nodes_);
  index_.reserve (items.size());
  for (const Item& item : items) {
    points_.add (item.position.x(), item.position.y(), item.position.z());
    index_.push_back (item.index);
  }
}

void
BoxTree::find (const NeighborQuery& query,
               pcl::Indices& indices,
               std::vector<float>& squared_distances) const
{
  NearestCandidates candidates (std::min (query.max_neighbors, index_.size()),
                                query.squared_radius);
  Postponed postponed;
  if (!nodes_.empty() && query.max_neighbors > 0)
    postponeChildren (nodes_, 0, query.position, candidates, postponed);
  while (postponed.number > 0) {
    const std::uint64_t next = postponed.children[--postponed.number];
    const auto slot = static_cast<std::uint32_t> (next);
    const Node& parent = nodes_[slot / max_children];
    if (!candidates.mayTake (next >> Postponed::child_bits,
                             parent.lowest_index[slot % max_children]))
      continue;
    const Child& child = parent.children[slot % max_children];
    if (child.size > 0)
      visitLeaf (child, points_, index_, query.position, candidates);
    else
      postponeChildren (nodes_, child.first, query.position, candidates, postponed);
  }
  candidates.take (query.sorted, indices, squared_distances);
}

} // namespace pcl_ops::internal

namespace pcl_ops::detail {

std::shared_ptr<const internal::BoxTree>
buildBoxTree (const CloudView& cloud, const pcl::Indices* indices)
{
  constexpr unsigned one_thread = 1;
  const internal::Points points = internal::finitePoints (cloud, one_thread, indices);
  return std::make_shared<const internal::BoxTree> (points, cloud);
}

void
findNeighbors (const internal::BoxTree* tree,
               const NeighborQuery& query,
               pcl::Indices& indices,
               std::vector<float>& squared_distances)
{
  indices.clear();
  squared_distances.clear();
  if (tree && query.position.allFinite())
    tree->find (query, indices, squared_distances);
}

} // namespace pcl_ops::detail
