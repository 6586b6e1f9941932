// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cell_keys.h"
#include "cell_sorting.h"
#include "cell_table.h"
#include "cell_tree_limits.h"
#include <pcl_ops/cell_tree.h>

#include <algorithm>
#include <array>

namespace pcl_ops {

namespace {

// Measured on scans of rooms: both larger and smaller ones are built and searched
// slower.
constexpr double points_per_cell = 40.0;
constexpr std::uint32_t points_of_leaf = 40;

double
cellEdge (const Coordinates& points)
{
  const double wanted_cells = static_cast<double> (points.size()) / points_per_cell;
  const double edge = cellSizeFor (points, std::max (1.0, wanted_cells));
  return edge > 0.0 ? edge : 1.0;
}

struct PointCells {
  CellTable table;
  std::vector<std::uint32_t> cell_of_point;
};

PointCells
cellsOf (const Coordinates& points)
{
  PointCells cells;
  cells.cell_of_point.resize (points.size());
  forRuns (points,
           cellEdge (points),
           0,
           points.size(),
           [&cells] (std::size_t first, std::size_t last, const CellKey& key) {
             std::fill (
                 cells.cell_of_point.begin() + static_cast<std::ptrdiff_t> (first),
                 cells.cell_of_point.begin() + static_cast<std::ptrdiff_t> (last),
                 cells.table.insert (key));
           });
  return cells;
}

bool
isLeaf (std::ptrdiff_t items, std::uint32_t points)
{
  return items == 1 || points <= points_of_leaf;
}

template <typename Item>
std::uint32_t
countPoints (const Item* begin, const Item* end)
{
  std::uint32_t points = 0;
  for (const Item* item = begin; item != end; ++item)
    points += item->points;
  return points;
}

struct Side {
  std::size_t axis;
  float middle;
};

template <typename Item>
Side
longestSide (const Item* begin, const Item* end)
{
  std::array<float, 3> low = begin->position, high = low;
  for (const Item* item = begin; item != end; ++item)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low[axis] = std::min (low[axis], item->position[axis]);
      high[axis] = std::max (high[axis], item->position[axis]);
    }
  const std::array<float, 3> length{
      high[0] - low[0], high[1] - low[1], high[2] - low[2]};
  const auto axis = static_cast<std::size_t> (
      std::max_element (length.begin(), length.end()) - length.begin());
  return {axis, low[axis] + 0.5f * length[axis]};
}

// Divides items at the middle of the longest side of their box, which takes one pass
// and makes compact boxes; at the median where most are on one side of that.
template <typename Item>
Item*
divide (Item* begin, Item* end)
{
  const Side side = longestSide (begin, end);
  Item* const middle = std::partition (begin, end, [side] (const Item& item) {
    return item.position[side.axis] < side.middle;
  });
  const auto smaller_share = [&] { return std::min (middle - begin, end - middle); };
  constexpr std::ptrdiff_t least_share = 4;
  if (least_share * smaller_share() >= end - begin)
    return middle;
  Item* const median = begin + (end - begin) / 2;
  std::nth_element (
      begin, median, end, [axis = side.axis] (const Item& first, const Item& second) {
        return first.position[axis] < second.position[axis];
      });
  return median;
}

} // namespace

CellTree::CellTree (const Points& points, const CloudPositions& cloud)
{
  if (points.size() == 0)
    return;
  sortIntoCells (points, cloud);
  splitCrowdedLeaves();
  computeBoxes();
}

void
CellTree::sortIntoCells (const Points& points, const CloudPositions& cloud)
{
  const PointCells cells = cellsOf (points);
  const std::vector<CellKey>& keys = cells.table.keys();
  const std::vector<std::uint32_t> count =
      countPerCell (cells.cell_of_point, keys.size());
  std::vector<Item> items (keys.size());
  for (std::uint32_t cell = 0; cell < keys.size(); ++cell)
    items[cell] = {{static_cast<float> (keys[cell].x),
                    static_cast<float> (keys[cell].y),
                    static_cast<float> (keys[cell].z)},
                   cell,
                   count[cell]};
  const auto number = static_cast<std::uint32_t> (points.size());
  grow ({items.data(), items.data() + items.size(), number}, 0);
  std::vector<std::uint32_t> cell_begin (keys.size());
  std::uint32_t begin = 0;
  for (const Item& item : items) {
    cell_begin[item.id] = begin;
    begin += item.points;
  }
  points_.resize (points.size());
  index_.resize (points.size());
  forPlacesByCell (cells.cell_of_point,
                   std::move (cell_begin),
                   [&] (std::size_t i, std::uint32_t place) {
                     const float* const position = cloud[points.indexOf (i)];
                     points_.x[place] = position[0];
                     points_.y[place] = position[1];
                     points_.z[place] = position[2];
                     index_[place] = points.indexOf (i);
                   });
}

std::uint32_t
CellTree::grow (const ItemRange& items, std::uint32_t first_point)
{
  const auto number = static_cast<std::uint32_t> (nodes_.size());
  nodes_.emplace_back();
  for (const ItemRange& range : split (items)) {
    Child child{first_point, range.points};
    if (!isLeaf (range.end - range.begin, range.points))
      child = {grow (range, first_point), 0};
    first_point += range.points;
    Node& node = nodes_[number];
    node.children[node.number++] = child;
  }
  return number;
}

std::vector<CellTree::ItemRange>
CellTree::split (const ItemRange& items)
{
  std::vector<ItemRange> ranges{items}, halves;
  for (std::size_t most = 2; most <= most_children; most *= 2) {
    halves.clear();
    for (const ItemRange& range : ranges)
      if (isLeaf (range.end - range.begin, range.points))
        halves.push_back (range);
      else {
        Item* const middle = divide (range.begin, range.end);
        halves.push_back ({range.begin, middle, countPoints (range.begin, middle)});
        halves.push_back ({middle, range.end, countPoints (middle, range.end)});
      }
    ranges.swap (halves);
  }
  return ranges;
}

CellTree::Child
CellTree::splitCrowded (Child leaf)
{
  std::vector<Item> items (leaf.size);
  for (std::uint32_t i = 0; i < leaf.size; ++i) {
    const std::uint32_t point = leaf.first + i;
    items[i] = {{points_.x[point], points_.y[point], points_.z[point]},
                static_cast<std::uint32_t> (index_[point]),
                1};
  }
  const std::uint32_t node =
      grow ({items.data(), items.data() + items.size(), leaf.size}, leaf.first);
  for (std::uint32_t i = 0; i < leaf.size; ++i) {
    const std::uint32_t point = leaf.first + i;
    points_.x[point] = items[i].position[0];
    points_.y[point] = items[i].position[1];
    points_.z[point] = items[i].position[2];
    index_[point] = static_cast<pcl::index_t> (items[i].id);
  }
  return {node, 0};
}

void
CellTree::splitCrowdedLeaves()
{
  const std::size_t nodes_over_cells = nodes_.size();
  for (std::size_t node = 0; node < nodes_over_cells; ++node)
    for (std::uint32_t i = 0; i < nodes_[node].number; ++i)
      if (nodes_[node].children[i].size > most_points_of_leaf) {
        const Child split = splitCrowded (nodes_[node].children[i]);
        nodes_[node].children[i] = split;
      }
}

void
CellTree::computeBoxes()
{
  for (std::size_t node = nodes_.size(); node-- > 0;)
    for (std::uint32_t child = 0; child < nodes_[node].number; ++child)
      computeBox (nodes_[node], child);
}

void
CellTree::computeBox (Node& node, std::uint32_t child) const
{
  const Child& held = node.children[child];
  const auto bound = [child] (const float* lows,
                              const float* highs,
                              std::size_t number,
                              OfChildren& low,
                              OfChildren& high) {
    using Values = Eigen::Map<const Eigen::ArrayXf>;
    const auto size = static_cast<Eigen::Index> (number);
    low[child] = Values (lows, size).minCoeff();
    high[child] = Values (highs, size).maxCoeff();
  };
  if (held.size > 0) {
    const float* const x = &points_.x[held.first];
    const float* const y = &points_.y[held.first];
    const float* const z = &points_.z[held.first];
    bound (x, x, held.size, node.low_x, node.high_x);
    bound (y, y, held.size, node.low_y, node.high_y);
    bound (z, z, held.size, node.low_z, node.high_z);
    return;
  }
  const Node& below = nodes_[held.first];
  bound (
      below.low_x.data(), below.high_x.data(), below.number, node.low_x, node.high_x);
  bound (
      below.low_y.data(), below.high_y.data(), below.number, node.low_y, node.high_y);
  bound (
      below.low_z.data(), below.high_z.data(), below.number, node.low_z, node.high_z);
}

} // namespace pcl_ops
