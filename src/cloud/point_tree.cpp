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

constexpr std::uint32_t max_points_of_tree_leaf = 8;

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
squaredDistanceToBox (const std::array<float, 3>& place, const PointTree::Node& node)
{
  float sum = 0.0F;
  for (int axis = 0; axis < 3; ++axis) {
    const float outside =
        std::max ({node.low[axis] - place[axis], place[axis] - node.high[axis], 0.0F});
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

// Number of nodes of a tree. Nodes at the same depth have the same number of points, or
// differ by one.
std::uint32_t
nodesOf (std::uint32_t points)
{
  if (points <= max_points_of_tree_leaf)
    return 1;
  // Number of nodes at the last depth at which all or some nodes are divided.
  std::uint32_t deepest = 1;
  while (points > 2 * deepest * max_points_of_tree_leaf)
    deepest *= 2;
  const bool are_all = points / deepest > max_points_of_tree_leaf;
  const std::uint32_t divided = are_all ? deepest : points % deepest;
  return 2 * deepest - 1 + 2 * divided;
}

} // namespace

PointTree::PointTree (const Coordinates& points, unsigned threads)
: nodes_ (nodesOf (static_cast<std::uint32_t> (points.size()))), order_ (points.size())
{
  constexpr std::size_t subtrees = 16;
  std::iota (order_.begin(), order_.end(), 0U);
  std::vector<std::uint32_t> roots;
  if (points.size() > 0) {
    nodes_[0] = {{}, {}, 0, static_cast<std::uint32_t> (points.size()), 0};
    roots.push_back (0);
  }
  while (!roots.empty() && roots.size() < subtrees) {
    std::vector<std::uint32_t> halves (2 * roots.size(), 0);
    parallelFor (threads, roots.size(), 1, [&] (std::size_t i, std::size_t) {
      if (divide (points, roots[i])) {
        halves[2 * i] = roots[i] + 1;
        halves[2 * i + 1] = nodes_[roots[i]].second_child;
      }
    });
    halves.erase (std::remove (halves.begin(), halves.end(), 0U), halves.end());
    roots = std::move (halves);
  }
  parallelFor (threads, roots.size(), 1, [&] (std::size_t i, std::size_t) {
    divideAll (points, roots[i]);
  });
  sorted_ = selected (points, order_);
}

void
PointTree::divideAll (const Coordinates& points, std::uint32_t number)
{
  if (!divide (points, number))
    return;
  divideAll (points, number + 1);
  divideAll (points, nodes_[number].second_child);
}

bool
PointTree::divide (const Coordinates& points, std::uint32_t number)
{
  Node& node = nodes_[number];
  int longest = 0;
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
    if (high - low > node.high[longest] - node.low[longest])
      longest = axis;
  }
  if (node.end - node.begin <= max_points_of_tree_leaf)
    return false;
  const std::vector<float>& values = axisOf (points, longest);
  const std::uint32_t middle = node.begin + (node.end - node.begin) / 2;
  std::nth_element (order_.begin() + node.begin,
                    order_.begin() + middle,
                    order_.begin() + node.end,
                    [&] (std::uint32_t first, std::uint32_t second) {
                      return values[first] != values[second]
                                 ? values[first] < values[second]
                                 : first < second;
                    });
  node.second_child = number + 1 + nodesOf (middle - node.begin);
  nodes_[number + 1] = {{}, {}, node.begin, middle, 0};
  nodes_[node.second_child] = {{}, {}, middle, node.end, 0};
  return true;
}

float
PointTree::squaredDistance (std::size_t first, std::size_t second) const
{
  const float x = sorted_.x[first] - sorted_.x[second];
  const float y = sorted_.y[first] - sorted_.y[second];
  const float z = sorted_.z[first] - sorted_.z[second];
  return x * x + y * y + z * z;
}

void
PointTree::find (std::size_t position, NearestPoints& nearest) const
{
  constexpr std::size_t max_depth = 64;
  struct Open {
    float squared_distance;
    std::uint32_t node;
  };
  const std::array<float, 3> query{
      sorted_.x[position], sorted_.y[position], sorted_.z[position]};
  const auto opened = [&] (std::uint32_t number) {
    return Open{squaredDistanceToBox (query, nodes_[number]), number};
  };
  std::array<Open, max_depth> open;
  std::size_t number_open = 0;
  open[number_open++] = {0.0F, 0};
  while (number_open > 0) {
    const Open next = open[--number_open];
    if (next.squared_distance > nearest.bound())
      continue;
    const Node& node = nodes_[next.node];
    if (node.second_child == 0) {
      for (std::uint32_t i = node.begin; i < node.end; ++i)
        nearest.offer (squaredDistance (i, position), order_[i]);
      continue;
    }
    Open near = opened (next.node + 1);
    Open far = opened (node.second_child);
    if (far.squared_distance < near.squared_distance)
      std::swap (near, far);
    open[number_open++] = far;
    open[number_open++] = near;
  }
}

std::vector<PointTree::Leaf>
PointTree::leaves (std::size_t wanted) const
{
  // Enlarges the reach so that rounding errors exclude no neighbor.
  constexpr float rounding = 1.0F + 1e-5F;
  std::vector<Leaf> leaves;
  std::vector<std::pair<std::uint32_t, float>> open;
  if (!nodes_.empty())
    open.emplace_back (0, std::numeric_limits<float>::infinity());
  while (!open.empty()) {
    auto [number, reach] = open.back();
    open.pop_back();
    const Node& node = nodes_[number];
    if (node.end - node.begin >= wanted)
      reach = std::sqrt (squaredDiagonal (node)) * rounding;
    if (node.second_child == 0) {
      leaves.push_back ({&node, reach});
      continue;
    }
    open.emplace_back (node.second_child, reach);
    open.emplace_back (number + 1, reach);
  }
  return leaves;
}

std::size_t
PointTree::findLeavesAround (const Node& node,
                             float distance,
                             std::size_t max_points,
                             Ranges& ranges) const
{
  constexpr std::size_t max_depth = 64;
  std::array<std::uint32_t, max_depth> open;
  std::size_t number_open = 0;
  std::size_t points = 0;
  ranges.clear();
  open[number_open++] = 0;
  while (number_open > 0 && points <= max_points) {
    const std::uint32_t number = open[--number_open];
    const Node& next = nodes_[number];
    if (squaredDistanceOfBoxes (node, next) > distance * distance)
      continue;
    if (next.second_child != 0) {
      open[number_open++] = next.second_child;
      open[number_open++] = number + 1;
      continue;
    }
    points += next.end - next.begin;
    if (!ranges.empty() && ranges.back().second == next.begin)
      ranges.back().second = next.end;
    else
      ranges.emplace_back (next.begin, next.end);
  }
  return points;
}

} // namespace pcl_ops::internal
