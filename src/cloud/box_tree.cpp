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

using SquaredDistances = Eigen::Array<float, BoxTree::max_children, 1>;

// Returns the squared distances of a position to the boxes of the children. They are
// computed and rounded like those of points, so no point in a box is nearer than the
// box.
SquaredDistances
squaredDistances (const Node& node, const Eigen::Vector3f& position)
{
  const auto squaredDistancesAlong = [&] (Eigen::Index axis) {
    const float coordinate = position[axis];
    return (node.low.col (axis) - coordinate)
        .max (coordinate - node.high.col (axis))
        .max (0.0f)
        .square()
        .eval();
  };
  return squaredDistancesAlong (0) + squaredDistancesAlong (1) +
         squaredDistancesAlong (2);
}

// Adds the points of a leaf to the candidates.
// \param[in] points, index of the tree: BoxTree::points_ and index_
void
visitLeaf (const Child& leaf,
           const Coordinates& points,
           const pcl::Indices& index,
           const Eigen::Vector3f& position,
           NearestCandidates& candidates)
{
  std::array<float, BoxTree::max_points_of_leaf> squared_distances;
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
    squared_distances[i] = dx * dx + dy * dy + dz * dz;
  }
  candidates.add (squared_distances.data(), &index[leaf.first], leaf.size);
}

/** \brief Stack of children still to be visited, the next one on top. The upper bits of
 * an entry are those of the squared distance of the child, so that entries sort by it.
 * The lower bits_of_child bits are the index of the child's node times max_children,
 * plus the index of the child in that node. */
struct PostponedChildren {
  static constexpr int bits_of_child = 32;
  // A division puts at most 3/4 of the points on a side, and 2^32 (3/4)^78 < 1: a tree
  // over 2^32 points has at most 78 divisions, of which a level of nodes makes three.
  // At most the children of one node wait on each level.
  static constexpr std::size_t max_levels = 78 / 3;

  std::array<std::uint64_t, max_levels * BoxTree::max_children> entries;
  std::size_t size = 0;
};

// Pushes the children of a node on top of the stack, the nearest one topmost.
void
postponeChildren (const std::vector<Node>& nodes,
                  std::uint32_t node_index,
                  const Eigen::Vector3f& position,
                  const NearestCandidates& candidates,
                  PostponedChildren& postponed)
{
  const Node& node = nodes[node_index];
  const SquaredDistances squared_distances = squaredDistances (node, position);
  const std::size_t first_slot = postponed.size;
  for (std::uint32_t i = 0; i < node.child_count; ++i) {
    const std::uint64_t distance_bits =
        NearestCandidates::bitsOf (squared_distances[i]);
    if (!candidates.mayTake (distance_bits, node.lowest_index[i]))
      continue;
    const std::uint64_t entry = distance_bits << PostponedChildren::bits_of_child |
                                (node_index * BoxTree::max_children + i);
    std::size_t slot = postponed.size++;
    for (; slot > first_slot && postponed.entries[slot - 1] < entry; --slot)
      postponed.entries[slot] = postponed.entries[slot - 1];
    postponed.entries[slot] = entry;
  }
}

/** \brief A point with its index in the cloud. */
struct IndexedPoint {
  Eigen::Vector3f position;
  pcl::index_t index;
};

/** \brief A range of points with its bounding box. */
struct Range {
  IndexedPoint* begin;
  IndexedPoint* end;
  Eigen::AlignedBox3f box;
  pcl::index_t lowest_index = std::numeric_limits<pcl::index_t>::max();

  Range (IndexedPoint* range_begin, IndexedPoint* range_end)
  : begin (range_begin), end (range_end)
  {
    for (const IndexedPoint* point = begin; point != end; ++point) {
      box.extend (point->position);
      lowest_index = std::min (lowest_index, point->index);
    }
  }

  bool
  isLeaf () const
  {
    return end - begin <= std::ptrdiff_t (BoxTree::max_points_of_leaf);
  }
};

// Divides points at the middle of the longest edge of their box, which makes compact
// boxes; at the median if one half would get less than a quarter of the points, so that
// the tree is not deep. Reorders the points, and returns the first one of the second
// half.
IndexedPoint*
divide (const Range& points)
{
  Eigen::Index axis = 0;
  points.box.sizes().maxCoeff (&axis);
  const float center = points.box.center()[axis];
  IndexedPoint* const middle =
      std::partition (points.begin, points.end, [=] (const IndexedPoint& point) {
        return point.position[axis] < center;
      });
  const std::ptrdiff_t size = points.end - points.begin;
  const std::ptrdiff_t size_of_smaller =
      std::min (middle - points.begin, points.end - middle);
  const bool has_smaller_a_quarter = 4 * size_of_smaller >= size;
  if (has_smaller_a_quarter)
    return middle;
  // Equal coordinates are sorted by index: a search among equal points can stop early.
  IndexedPoint* const median = points.begin + size / 2;
  std::nth_element (points.begin,
                    median,
                    points.end,
                    [=] (const IndexedPoint& first, const IndexedPoint& second) {
                      const float a = first.position[axis];
                      const float b = second.position[axis];
                      return a != b ? a < b : first.index < second.index;
                    });
  return median;
}

// Splits points into the ranges of the children of a node: up to three times, each
// range into two, unless it has few enough points for a leaf.
std::vector<Range>
split (const Range& points)
{
  std::vector<Range> ranges{points};
  std::vector<Range> halves;
  for (std::size_t max_ranges = 2; max_ranges <= BoxTree::max_children;
       max_ranges *= 2) {
    halves.clear();
    for (const Range& range : ranges)
      if (range.isLeaf())
        halves.push_back (range);
      else {
        IndexedPoint* const middle = divide (range);
        halves.emplace_back (range.begin, middle);
        halves.emplace_back (middle, range.end);
      }
    ranges.swap (halves);
  }
  return ranges;
}

// Adds a node over points, and the nodes below it; returns the index of the node.
// Reorders the points leaf by leaf.
// \param[in] first the first point of the tree
std::uint32_t
addNode (const IndexedPoint* first, const Range& points, std::vector<Node>& nodes)
{
  const auto node_index = static_cast<std::uint32_t> (nodes.size());
  nodes.emplace_back();
  for (const Range& range : split (points)) {
    const auto begin = static_cast<std::uint32_t> (range.begin - first);
    const auto size = static_cast<std::uint32_t> (range.end - range.begin);
    const Child child =
        range.isLeaf() ? Child{begin, size} : Child{addNode (first, range, nodes), 0};
    Node& node = nodes[node_index];
    const std::uint32_t i = node.child_count++;
    node.children[i] = child;
    node.lowest_index[i] = range.lowest_index;
    node.low.row (i) = range.box.min().transpose();
    node.high.row (i) = range.box.max().transpose();
  }
  return node_index;
}

} // namespace

BoxTree::BoxTree (const Points& points, const CloudView& cloud)
{
  std::vector<IndexedPoint> indexed;
  indexed.reserve (points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const pcl::index_t index = points.indexOf (i);
    const float* const position = cloud[index];
    indexed.push_back ({{position[0], position[1], position[2]}, index});
  }
  if (!indexed.empty())
    addNode (indexed.data(), {indexed.data(), indexed.data() + indexed.size()}, nodes_);
  index_.reserve (indexed.size());
  for (const IndexedPoint& point : indexed) {
    points_.add (point.position.x(), point.position.y(), point.position.z());
    index_.push_back (point.index);
  }
}

void
BoxTree::find (const NeighborQuery& query,
               pcl::Indices& indices,
               std::vector<float>& squared_distances) const
{
  NearestCandidates candidates (std::min (query.max_neighbors, index_.size()),
                                query.squared_radius);
  PostponedChildren postponed;
  if (!nodes_.empty() && query.max_neighbors > 0)
    postponeChildren (nodes_, 0, query.position, candidates, postponed);
  while (postponed.size > 0) {
    const std::uint64_t entry = postponed.entries[--postponed.size];
    const auto node_and_child = static_cast<std::uint32_t> (entry);
    const Node& node = nodes_[node_and_child / max_children];
    const std::size_t child_index = node_and_child % max_children;
    if (!candidates.mayTake (entry >> PostponedChildren::bits_of_child,
                             node.lowest_index[child_index]))
      continue;
    const Child& child = node.children[child_index];
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
