// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud/points.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace pcl_ops::internal {

/** \brief The nearest of the points that were offered, nearest first; of equally near
 * ones those with the lowest numbers. */
class NearestPoints {
public:
  static constexpr std::size_t max_size = 128;

  /** \param[in] wanted 1 to \ref max_size */
  void
  start (std::size_t wanted)
  {
    wanted_ = wanted;
    size_ = 0;
    bound_ = std::numeric_limits<float>::infinity();
  }

  void
  offer (float squared_distance, std::uint32_t number)
  {
    if (squared_distance > bound_ ||
        (size_ == wanted_ && !isLess (squared_distance, number, size_ - 1)))
      return;
    std::size_t place = size_ < wanted_ ? size_++ : size_ - 1;
    for (; place > 0 && isLess (squared_distance, number, place - 1); --place) {
      distances_[place] = distances_[place - 1];
      numbers_[place] = numbers_[place - 1];
    }
    distances_[place] = squared_distance;
    numbers_[place] = number;
    if (size_ == wanted_)
      bound_ = distances_[size_ - 1];
  }

  /** \brief None farther away is taken [m^2]. */
  float
  bound () const
  {
    return bound_;
  }

  std::size_t
  size () const
  {
    return size_;
  }

  std::uint32_t
  operator[] (std::size_t i) const
  {
    return numbers_[i];
  }

private:
  bool
  isLess (float squared_distance, std::uint32_t number, std::size_t than) const
  {
    return squared_distance < distances_[than] ||
           (squared_distance == distances_[than] && number < numbers_[than]);
  }

  std::array<float, max_size> distances_;
  std::array<std::uint32_t, max_size> numbers_;
  std::size_t wanted_ = 0;
  std::size_t size_ = 0;
  float bound_ = 0.0F;
};

/** \brief A k-d tree for the nearest points of the points themselves. */
class PointTree {
public:
  /** \param[in] points finite; the tree keeps a copy */
  explicit PointTree (const Coordinates& points, unsigned threads = 1);

  /** \brief The number of the point at each position of the tree: points that follow
   * each other there are near each other. */
  const Indices&
  order () const
  {
    return order_;
  }

  /** \brief Offers all points that may be wanted.
   * \param[in] position of the query in \ref order
   * \param[in,out] nearest started; gets numbers of points, the query's own, too */
  void
  find (std::size_t position, NearestPoints& nearest) const;

  /** \brief The points at all positions, local frame. */
  const Coordinates&
  sorted () const
  {
    return sorted_;
  }

  /** \brief Points that follow each other in \ref order. */
  struct Node {
    std::array<float, 3> low, high; // of their box
    std::uint32_t begin, end;
    std::uint32_t second_child; // 0: a leaf; the first child follows its parent
  };

  /** \brief A leaf, and a radius [m] within which each of its points has as many points
   * as were wanted, itself included; infinite if the tree has fewer. */
  struct Leaf {
    const Node* node;
    float reach;
  };

  /** \brief The leaves in their order.
   * \param[in] wanted points within the reach of each */
  std::vector<Leaf>
  leaves (std::size_t wanted) const;

  /** \brief Pairs of begin and end of positions, ascending. */
  using Ranges = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

  /** \brief Finds the positions of leaves whose boxes are within a distance [m] of the
   * box of a node; stops as soon as they are more than a number of points.
   * \return how many points they have */
  std::size_t
  findLeavesAround (const Node& node,
                    float distance,
                    std::size_t max_points,
                    Ranges& ranges) const;

private:
  float
  squaredDistance (std::size_t first, std::size_t second) const;

  // Gives a node its box and, if it has too many points for a leaf, its children.
  bool
  divide (const Coordinates& points, std::uint32_t number);

  void
  divideAll (const Coordinates& points, std::uint32_t number);

  std::vector<Node> nodes_;
  Indices order_;
  Coordinates sorted_;
};

} // namespace pcl_ops::internal
