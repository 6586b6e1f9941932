// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud/octant_neighbors.h"

#include "base/parallel.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace pcl_ops::internal {
namespace {

// The points of a leaf are a group: it has 4 to 8 points, as larger nodes are halved.
// Chosen by hand.
constexpr std::uint32_t max_points_of_leaf = 8;

/** \brief Returns whether no point of a box can be nearer than the neighbors already
 * known in the octants that the box overlaps.
 * \param[in] low, high corners of the box relative to the query position [m] */
bool
isTooFar (const Eigen::Array2d& low,
          const Eigen::Array2d& high,
          const OctantNeighbors& nearest)
{
  const Eigen::Array2d outside = low.max (-high).max (0.0);
  const double squared_distance = outside.square().sum();
  if (squared_distance == 0.0)
    return false;
  // Seen from outside, a box spans less than half a turn. So count its octants from
  // that of its center: from -half_turn to half_turn - 1.
  constexpr int half_turn = octants / 2;
  constexpr int turn = octants;
  const int center = static_cast<int> (octantOf (0.5 * (low + high)));
  int first = 0;
  int last = 0;
  for (const double x : {low.x(), high.x()})
    for (const double y : {low.y(), high.y()}) {
      const int octant = static_cast<int> (octantOf ({x, y}));
      const int from_center = (octant - center + turn + half_turn) % turn - half_turn;
      first = std::min (first, from_center);
      last = std::max (last, from_center);
      // Half a turn away may be on either side.
      if (from_center == -half_turn)
        last = half_turn - 1;
    }
  for (int from_center = first; from_center <= last; ++from_center) {
    const int octant = (center + from_center + turn) % turn;
    if (squared_distance <= nearest.squared_distances[octant])
      return false;
  }
  return true;
}

/** \brief Takes a point as the neighbor in its octant if it is nearer than the present
 * one, or as near with a lower index.
 * \param[in] offset vector from the query position to the point; zero is ignored
 * \param[in] point its index */
void
offer (const Eigen::Vector2d& offset, std::uint32_t point, OctantNeighbors& nearest)
{
  const double squared_distance = offset.squaredNorm();
  if (squared_distance == 0.0)
    return;
  const std::size_t octant = octantOf (offset);
  auto present = std::tie (nearest.squared_distances[octant], nearest.points[octant]);
  if (std::tie (squared_distance, point) < present)
    present = std::tie (squared_distance, point);
}

/** \brief Returns the mean of the points with the given indices. To the last bit it
 * does not depend on the order of the points, which decides about the order of a sum.
 * \param[in] chosen one or more indices, by value to be sorted here */
Eigen::Vector2d
meanOf (std::vector<std::uint32_t> chosen, const PlanarPoints& points)
{
  std::sort (chosen.begin(), chosen.end(), [&] (std::uint32_t a, std::uint32_t b) {
    return std::make_tuple (points[a].x(), points[a].y()) <
           std::make_tuple (points[b].x(), points[b].y());
  });
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const std::uint32_t point : chosen)
    mean += points[point] / static_cast<double> (chosen.size());
  return mean;
}

} // namespace

std::size_t
octantOf (const Eigen::Vector2d& direction)
{
  // Other directions are turned by half a turn into the first half.
  const bool is_in_first_half =
      direction.y() > 0.0 || (direction.y() == 0.0 && direction.x() > 0.0);
  const Eigen::Vector2d turned =
      is_in_first_half ? direction : Eigen::Vector2d (-direction);
  const double x = turned.x();
  const double y = turned.y();
  const std::size_t first_of_half = is_in_first_half ? 0 : octants / 2;
  if (x > 0.0)
    return first_of_half + (y < x ? 0 : 1);
  return first_of_half + (y > -x ? 2 : 3);
}

OctantTree::OctantTree (const PlanarPoints& points)
: points_ (points), order_ (points.size())
{
  std::iota (order_.begin(), order_.end(), 0U);
  if (!points.empty())
    build (0, static_cast<std::uint32_t> (points.size()));
}

void
OctantTree::build (std::uint32_t begin, std::uint32_t end)
{
  const std::size_t node_index = nodes_.size();
  Node node{points_[order_[begin]], points_[order_[begin]], begin, end};
  for (std::uint32_t i = begin; i < end; ++i) {
    node.low = node.low.min (points_[order_[i]].array());
    node.high = node.high.max (points_[order_[i]].array());
  }
  nodes_.push_back (node);
  if (end - begin <= max_points_of_leaf) {
    std::sort (order_.begin() + begin, order_.begin() + end);
    return;
  }
  const Eigen::Array2d size = node.high - node.low;
  const Eigen::Index long_axis = size.y() > size.x() ? 1 : 0;
  const Eigen::Index short_axis = 1 - long_axis;
  const std::uint32_t middle = begin + (end - begin) / 2;
  // All points differ, so sorting by both coordinates is unambiguous.
  std::nth_element (
      order_.begin() + begin,
      order_.begin() + middle,
      order_.begin() + end,
      [&] (std::uint32_t a, std::uint32_t b) {
        return std::make_tuple (points_[a][long_axis], points_[a][short_axis]) <
               std::make_tuple (points_[b][long_axis], points_[b][short_axis]);
      });
  build (begin, middle);
  nodes_[node_index].second_child = static_cast<std::uint32_t> (nodes_.size());
  build (middle, end);
}

void
OctantTree::search (std::size_t node_index,
                    const Eigen::Vector2d& position,
                    std::size_t skipped_node,
                    OctantNeighbors& nearest) const
{
  const Node& node = nodes_[node_index];
  if (node_index == skipped_node ||
      isTooFar (node.low - position.array(), node.high - position.array(), nearest))
    return;
  if (node.second_child == 0) {
    for (std::uint32_t i = node.begin; i < node.end; ++i)
      offer (points_[order_[i]] - position, order_[i], nearest);
    return;
  }
  // The child on the side of the position comes first: the neighbors found there let
  // the search skip most of the other child.
  const std::size_t first_child = node_index + 1;
  const std::size_t second_child = node.second_child;
  const bool is_in_second = (position.array() >= nodes_[second_child].low).all();
  search (is_in_second ? second_child : first_child, position, skipped_node, nearest);
  search (is_in_second ? first_child : second_child, position, skipped_node, nearest);
}

OctantNeighbors
OctantTree::neighborsAt (const Eigen::Vector2d& position,
                         std::size_t skipped_node) const
{
  OctantNeighbors nearest;
  nearest.points.fill (no_neighbor);
  nearest.squared_distances.fill (std::numeric_limits<double>::infinity());
  search (0, position, skipped_node, nearest);
  return nearest;
}

OctantNeighbors
OctantTree::neighborsOf (std::uint32_t point) const
{
  const std::size_t no_node = nodes_.size();
  return neighborsAt (points_[point], no_node);
}

std::vector<OctantTree::Group>
OctantTree::groups (unsigned threads) const
{
  std::vector<std::size_t> leaves;
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    if (nodes_[i].second_child == 0)
      leaves.push_back (i);
  std::vector<Group> groups (leaves.size());
  forEach (threads, leaves.size(), [&] (std::size_t i) {
    const Node& leaf = nodes_[leaves[i]];
    Group& group = groups[i];
    group.points.assign (order_.begin() + leaf.begin, order_.begin() + leaf.end);
    group.center = meanOf (group.points, points_);
    group.neighbors = neighborsAt (group.center, leaves[i]);
  });
  return groups;
}

} // namespace pcl_ops::internal
