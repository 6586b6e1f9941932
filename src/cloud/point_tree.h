// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud/points.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace pcl_ops::internal {

/** \brief Keeps the nearest of the points that were offered, sorted by distance. Among
 * points at equal distance it keeps those with the lowest indices. */
class NearestPoints {
public:
  /** \brief Chosen by hand: three times the largest usual neighborhood
   * (PlaceConstants::max_neighborhood) and more. */
  static constexpr std::size_t max_size = 128;

  /** \brief Forgets all points.
   * \param[in] wanted number of points to keep, 1 to \ref max_size */
  void
  start (std::size_t wanted)
  {
    wanted_ = wanted;
    size_ = 0;
    squared_bound_ = std::numeric_limits<float>::infinity();
  }

  /** \brief Keeps a point if it is nearer than one of those kept, or if fewer than the
   * wanted number are kept. */
  void
  offer (float squared_distance, std::uint32_t index)
  {
    if (squared_distance > squared_bound_ ||
        (size_ == wanted_ && !comesBefore (squared_distance, index, size_ - 1)))
      return;
    std::size_t slot = size_ < wanted_ ? size_++ : size_ - 1;
    for (; slot > 0 && comesBefore (squared_distance, index, slot - 1); --slot) {
      squared_distances_[slot] = squared_distances_[slot - 1];
      indices_[slot] = indices_[slot - 1];
    }
    squared_distances_[slot] = squared_distance;
    indices_[slot] = index;
    if (size_ == wanted_)
      squared_bound_ = squared_distances_[size_ - 1];
  }

  /** \brief Squared distance beyond which no point is taken any more [m^2]. */
  float
  squaredBound () const
  {
    return squared_bound_;
  }

  std::size_t
  size () const
  {
    return size_;
  }

  /** \brief Index of the i-th nearest point, from 0 on. */
  std::uint32_t
  operator[] (std::size_t i) const
  {
    return indices_[i];
  }

private:
  // Returns whether a point comes before the one in a slot.
  bool
  comesBefore (float squared_distance, std::uint32_t index, std::size_t slot) const
  {
    return squared_distance < squared_distances_[slot] ||
           (squared_distance == squared_distances_[slot] && index < indices_[slot]);
  }

  std::array<float, max_size> squared_distances_;
  std::array<std::uint32_t, max_size> indices_;
  std::size_t wanted_ = 0;
  std::size_t size_ = 0;
  float squared_bound_ = 0.0F;
};

/** \brief A k-d tree that finds the nearest neighbors of its own points; \ref BoxTree
 * searches around any position. */
class PointTree {
public:
  /** \param[in] points finite points; the tree keeps a copy
   * \param[in] threads largest number of threads; 0: one for each processor */
  explicit PointTree (const Coordinates& points, unsigned threads = 1);

  /** \brief The index of the point at each position of the tree. Points at successive
   * positions are near each other in space. */
  const Indices&
  order () const
  {
    return order_;
  }

  /** \brief Searches the nearest neighbors of one of the points.
   * \param[in] position of the query point in \ref order
   * \param[in,out] nearest after NearestPoints::start; receives the neighbors and the
   * query point itself; the query point is missing if equal points with lower indices
   * fill the list */
  void
  find (std::size_t position, NearestPoints& nearest) const;

  /** \brief The points in the order of \ref order, with unchanged coordinates. */
  const Coordinates&
  sorted () const
  {
    return sorted_;
  }

  struct Node {
    std::array<float, 3> low, high; // bounding box [m]
    std::uint32_t begin, end;       // its positions in order(): begin to end - 1
    std::uint32_t second_child; // node index, 0: leaf; the first child is the next node
  };

  /** \brief A leaf and its reach. */
  struct Leaf {
    const Node* node;
    /** \brief A radius [m] within which each point of the leaf has the wanted number of
     * points, itself included; infinite if the tree has fewer points. */
    float reach;
  };

  /** \brief Returns the leaves by ascending positions.
   * \param[in] wanted number of points within the reach of each point of a leaf */
  std::vector<Leaf>
  leaves (std::size_t wanted) const;

  /** \brief Positions from begin to end - 1. */
  struct Range {
    std::uint32_t begin, end;
  };
  /** \brief Disjoint ranges, ascending. */
  using Ranges = std::vector<Range>;

  /** \brief Finds the leaves whose bounding boxes are within \p distance [m] of the box
   * of \p node. Stops once they have more than \p max_points points.
   * \param[out] ranges positions of the leaves found
   * \return number of points in \p ranges */
  std::size_t
  findLeavesAround (const Node& node,
                    float distance,
                    std::size_t max_points,
                    Ranges& ranges) const;

private:
  // Returns the squared distance between the points at two positions [m^2].
  float
  squaredDistance (std::size_t first, std::size_t second) const;

  // Sets the bounding box of a node. If the node has too many points for a leaf, makes
  // two children and returns true.
  bool
  divide (const Coordinates& points, std::uint32_t node_index);

  // Divides a node and all nodes below it.
  void
  divideAll (const Coordinates& points, std::uint32_t node_index);

  std::vector<Node> nodes_;
  Indices order_;
  Coordinates sorted_;
};

} // namespace pcl_ops::internal
