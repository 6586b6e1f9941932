// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud/point_tree.h"

#include "base/parallel.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace pcl_ops::internal {

namespace {

constexpr std::uint32_t max_points_of_tree_leaf = 8; // chosen by hand, for the time

const std::vector<float>&
axisOf (const Coordinates& points, int axis)
{
  return axis == 0 ? points.x : axis == 1 ? points.y : points.z;
}

float
squaredDiagonal (const PointTree::Node& node)
{
  float sum = 0.0F;
  for (int axis = 0; axis < 3; ++axis)
    sum += (node.high[axis] - node.low[axis]) * (node.high[axis] - node.low[axis]);
  return sum;
}

float
squaredDistanceToBox (const std::array<float, 3>& point, const PointTree::Node& node)
{
  float sum = 0.0F;
  for (int axis = 0; axis < 3; ++axis) {
    const float outside =
        std::max ({node.low[axis] - point[axis], point[axis] - node.high[axis], 0.0F});
    sum += outside * outside;
  }
  return sum;
}

float
squaredDistanceOfBoxes (const PointTree::Node& first, const PointTree::Node& second)
{
  float sum = 0.0F;
  for (int axis = 0; axis < 3; ++axis) {
    const float apart = std::max ({first.low[axis] - second.high[axis],
                                   second.low[axis] - first.high[axis],
                                   0.0F});
    sum += apart * apart;
  }
  return sum;
}

// Returns the number of nodes of a tree over so many points. The numbers of points of
// nodes at the same depth are equal, or differ by one.
std::uint32_t
countNodes (std::uint32_t points)
{
  if (points <= max_points_of_tree_leaf)
    return 1;
  // Number of nodes at the last depth at which all or some nodes are divided.
  std::uint32_t nodes_at_last_depth = 1;
  while (points > std::uint64_t (2) * nodes_at_last_depth * max_points_of_tree_leaf)
    nodes_at_last_depth *= 2;
  // If only some are divided, they are those with one point more than the others.
  const bool are_all_divided = points / nodes_at_last_depth > max_points_of_tree_leaf;
  const std::uint32_t divided_nodes =
      are_all_divided ? nodes_at_last_depth : points % nodes_at_last_depth;
  const std::uint32_t nodes_down_to_last_depth = 2 * nodes_at_last_depth - 1;
  return nodes_down_to_last_depth + 2 * divided_nodes;
}

} // namespace

PointTree::PointTree (const Coordinates& points, unsigned threads)
: nodes_ (countNodes (static_cast<std::uint32_t> (points.size())))
, order_ (points.size())
{
  // First the top of the tree is divided, until it has so many subtrees that threads
  // can share them: more threads than subtrees do not help. Then the subtrees are
  // divided in parallel.
  constexpr std::size_t subtrees = 16;
  constexpr std::size_t roots_per_piece = 1;
  std::iota (order_.begin(), order_.end(), 0U);
  std::vector<std::uint32_t> roots; // indices of the nodes to divide
  if (points.size() > 0) {
    nodes_[0] = {{}, {}, 0, static_cast<std::uint32_t> (points.size()), 0};
    roots.push_back (0);
  }
  while (!roots.empty() && roots.size() < subtrees) {
    std::vector<std::uint32_t> halves (2 * roots.size(), 0); // 0: no node
    parallelFor (
        threads, roots.size(), roots_per_piece, [&] (std::size_t i, std::size_t) {
          if (divide (points, roots[i])) {
            halves[2 * i] = roots[i] + 1;
            halves[2 * i + 1] = nodes_[roots[i]].second_child;
          }
        });
    halves.erase (std::remove (halves.begin(), halves.end(), 0U), halves.end());
    roots = std::move (halves);
  }
  parallelFor (threads,
               roots.size(),
               roots_per_piece,
               [&] (std::size_t i, std::size_t) { divideAll (points, roots[i]); });
  sorted_ = selected (points, order_);
}

void
PointTree::divideAll (const Coordinates& points, std::uint32_t node_index)
{
  if (!divide (points, node_index))
    return;
  divideAll (points, node_index + 1);
  divideAll (points, nodes_[node_index].second_child);
}

bool
PointTree::divide (const Coordinates& points, std::uint32_t node_index)
{
  Node& node = nodes_[node_index];
  int longest_axis = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const std::vector<float>& values = axisOf (points, axis);
    float low = values[order_[node.begin]];
    float high = low;
    for (std::uint32_t i = node.begin; i < node.end; ++i) {
      low = std::min (low, values[order_[i]]);
      high = std::max (high, values[order_[i]]);
    }
    node.low[axis] = low;
    node.high[axis] = high;
    if (high - low > node.high[longest_axis] - node.low[longest_axis])
      longest_axis = axis;
  }
  if (node.end - node.begin <= max_points_of_tree_leaf)
    return false;
  const std::vector<float>& values = axisOf (points, longest_axis);
  const std::uint32_t middle = node.begin + (node.end - node.begin) / 2;
  std::nth_element (order_.begin() + node.begin,
                    order_.begin() + middle,
                    order_.begin() + node.end,
                    [&] (std::uint32_t first, std::uint32_t second) {
                      return values[first] != values[second]
                                 ? values[first] < values[second]
                                 : first < second;
                    });
  node.second_child = node_index + 1 + countNodes (middle - node.begin);
  nodes_[node_index + 1] = {{}, {}, node.begin, middle, 0};
  nodes_[node.second_child] = {{}, {}, middle, node.end, 0};
  return true;
}

float
PointTree::squaredDistance (std::size_t first, std::size_t second) const
{
  const float dx = sorted_.x[first] - sorted_.x[second];
  const float dy = sorted_.y[first] - sorted_.y[second];
  const float dz = sorted_.z[first] - sorted_.z[second];
  return dx * dx + dy * dy + dz * dz;
}

void
PointTree::find (std::size_t position, NearestPoints& nearest) const
{
  // The open nodes are a stack of nodes to visit: at most one for each depth of the
  // tree, and one more. Each depth halves the points: 64 suffice for 2^32 points.
  constexpr std::size_t max_open = 64;
  struct OpenNode {
    float squared_distance;
    std::uint32_t node_index;
  };
  const std::array<float, 3> query{
      sorted_.x[position], sorted_.y[position], sorted_.z[position]};
  const auto openNode = [&] (std::uint32_t node_index) {
    return OpenNode{squaredDistanceToBox (query, nodes_[node_index]), node_index};
  };
  std::array<OpenNode, max_open> open;
  std::size_t open_count = 0;
  open[open_count++] = {0.0F, 0};
  while (open_count > 0) {
    const OpenNode next = open[--open_count];
    if (next.squared_distance > nearest.squaredBound())
      continue;
    const Node& node = nodes_[next.node_index];
    if (node.second_child == 0) {
      for (std::uint32_t i = node.begin; i < node.end; ++i)
        nearest.offer (squaredDistance (i, position), order_[i]);
      continue;
    }
    OpenNode near = openNode (next.node_index + 1);
    OpenNode far = openNode (node.second_child);
    if (far.squared_distance < near.squared_distance)
      std::swap (near, far);
    open[open_count++] = far;
    open[open_count++] = near;
  }
}

std::vector<PointTree::Leaf>
PointTree::leaves (std::size_t wanted) const
{
  // Factor of the reach, so that rounding errors exclude no neighbor.
  constexpr float enlargement = 1.0F + 1e-5F;
  struct OpenNode {
    std::uint32_t node_index;
    float reach; // of its parent: infinite for the root
  };
  std::vector<Leaf> leaves;
  // There is always a root: without points it is a leaf without points.
  std::vector<OpenNode> open{{0, std::numeric_limits<float>::infinity()}};
  while (!open.empty()) {
    const OpenNode next = open.back();
    open.pop_back();
    const Node& node = nodes_[next.node_index];
    const bool has_wanted = node.end - node.begin >= wanted;
    // The diagonal of the smallest node that contains this one and at least the wanted
    // number of points: this one itself, or an ancestor.
    const float reach =
        has_wanted ? std::sqrt (squaredDiagonal (node)) * enlargement : next.reach;
    if (node.second_child == 0) {
      leaves.push_back ({&node, reach});
      continue;
    }
    open.push_back ({node.second_child, reach});
    open.push_back ({next.node_index + 1, reach});
  }
  return leaves;
}

std::size_t
PointTree::findLeavesAround (const Node& node,
                             float distance,
                             std::size_t max_points,
                             Ranges& ranges) const
{
  constexpr std::size_t max_open = 64; // as in find
  std::array<std::uint32_t, max_open> open;
  std::size_t open_count = 0;
  std::size_t points = 0;
  ranges.clear();
  open[open_count++] = 0;
  while (open_count > 0 && points <= max_points) {
    const std::uint32_t other_index = open[--open_count];
    const Node& other = nodes_[other_index];
    if (squaredDistanceOfBoxes (node, other) > distance * distance)
      continue;
    if (other.second_child != 0) {
      open[open_count++] = other.second_child;
      open[open_count++] = other_index + 1;
      continue;
    }
    points += other.end - other.begin;
    if (!ranges.empty() && ranges.back().end == other.begin)
      ranges.back().end = other.end;
    else
      ranges.push_back ({other.begin, other.end});
  }
  return points;
}

} // namespace pcl_ops::internal
