// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "search/box_tree_builder.h"

#include "voxels/voxel_grid.h"
#include "voxels/voxel_size.h"

#include <algorithm>
#include <array>
#include <utility>

namespace pcl_ops::internal {

namespace {

// Measured on scans of rooms: both larger and smaller ones are built and searched
// slower.
constexpr double points_per_voxel = 40.0;
constexpr std::uint32_t points_of_leaf = 40;

double
voxelEdge (const Coordinates& points)
{
  const double wanted_voxels = static_cast<double> (points.size()) / points_per_voxel;
  const double edge = voxelSizeFor (points, std::max (1.0, wanted_voxels));
  return edge > 0.0 ? edge : 1.0;
}

using Node = BoxTree::Node;
using Child = BoxTree::Child;
using OfChildren = BoxTree::OfChildren;

/** \brief Something with a position that a node holds: a voxel or a point. */
struct Item {
  std::array<float, 3> position;
  std::uint32_t id;
  std::uint32_t points;
};

/** \brief Items of a child. */
struct ItemRange {
  Item* begin;
  Item* end;
  std::uint32_t points;
};

bool
isLeaf (std::ptrdiff_t items, std::uint32_t points)
{
  return items == 1 || points <= points_of_leaf;
}

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

std::vector<ItemRange>
split (const ItemRange& items)
{
  std::vector<ItemRange> ranges{items}, halves;
  for (std::size_t most = 2; most <= BoxTree::most_children; most *= 2) {
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

/** \brief Puts points and nodes where they belong, and gives them out as a tree. */
class BoxTreeBuilder {
public:
  void
  sortIntoVoxels (const Points& points, const CloudView& cloud);
  void
  splitCrowdedLeaves ();
  void
  computeBoxes ();

  BoxTree
  finish ()
  {
    return {std::move (nodes_), std::move (points_), std::move (index_)};
  }

private:
  /** \brief Adds a node over items, and others below it until leaves have few points or
   * one item.
   * \param[in,out] items reordered leaf after leaf
   * \param[in] first_point of the node
   * \return its number */
  std::uint32_t
  grow (const ItemRange& items, std::uint32_t first_point);
  Child
  splitCrowded (Child leaf);
  void
  computeBox (Node& node, std::uint32_t child) const;

  std::vector<Node> nodes_;
  Coordinates points_;
  pcl::Indices index_;
};

void
BoxTreeBuilder::sortIntoVoxels (const Points& points, const CloudView& cloud)
{
  const VoxelizedPoints voxelized = voxelize (points, voxelEdge (points), 1);
  const VoxelGrid& voxels = voxelized.grid;
  std::vector<Item> items (voxels.size());
  for (std::uint32_t voxel = 0; voxel < voxels.size(); ++voxel) {
    const VoxelKey key = numbersOf (voxels.codes[voxel]);
    items[voxel] = {{static_cast<float> (key.x),
                     static_cast<float> (key.y),
                     static_cast<float> (key.z)},
                    voxel,
                    voxels.endOfPoints (voxel) - voxels.first_point[voxel]};
  }
  const auto number = static_cast<std::uint32_t> (points.size());
  grow ({items.data(), items.data() + items.size(), number}, 0);
  index_.reserve (points.size());
  for (const Item& item : items)
    for (std::uint32_t i = voxels.first_point[item.id];
         i < voxels.endOfPoints (item.id);
         ++i) {
      const pcl::index_t index = points.indexOf (voxelized.order[i]);
      const float* const position = cloud[static_cast<std::size_t> (index)];
      points_.add (position[0], position[1], position[2]);
      index_.push_back (index);
    }
}

std::uint32_t
BoxTreeBuilder::grow (const ItemRange& items, std::uint32_t first_point)
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

Child
BoxTreeBuilder::splitCrowded (Child leaf)
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
BoxTreeBuilder::splitCrowdedLeaves()
{
  const std::size_t nodes_over_voxels = nodes_.size();
  for (std::size_t node = 0; node < nodes_over_voxels; ++node)
    for (std::uint32_t i = 0; i < nodes_[node].number; ++i)
      if (nodes_[node].children[i].size > BoxTree::most_points_of_leaf) {
        const Child split = splitCrowded (nodes_[node].children[i]);
        nodes_[node].children[i] = split;
      }
}

void
BoxTreeBuilder::computeBoxes()
{
  for (std::size_t node = nodes_.size(); node-- > 0;)
    for (std::uint32_t child = 0; child < nodes_[node].number; ++child)
      computeBox (nodes_[node], child);
}

void
BoxTreeBuilder::computeBox (Node& node, std::uint32_t child) const
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

} // namespace

BoxTree
buildBoxTree (const Points& points, const CloudView& cloud)
{
  if (points.size() == 0)
    return {};
  BoxTreeBuilder builder;
  builder.sortIntoVoxels (points, cloud);
  builder.splitCrowdedLeaves();
  builder.computeBoxes();
  return builder.finish();
}

} // namespace pcl_ops::internal
