// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "geometry/points.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace pcl_ops::internal {

/** \brief The nearest of the points that were offered, nearest first; of equally near
 * ones those with the lowest numbers. */
class NearestPoints {
public:
  static constexpr std::size_t max_size = 128;

  /** \param[in] wanted up to \ref max_size
   * \param[in] bound squared distance [m^2]; none farther away is wanted */
  void
  start (std::size_t wanted, float bound = std::numeric_limits<float>::infinity())
  {
    wanted_ = wanted;
    size_ = 0;
    bound_ = bound;
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
  explicit PointTree (const Coordinates& points);

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

  /** \brief The squared distance of the points at two positions [m^2]. */
  float
  squaredDistance (std::size_t first, std::size_t second) const;

private:
  struct Node {
    std::array<float, 3> low, high;
    std::uint32_t begin, end;
    std::uint32_t second_child; // 0: a leaf; the first child follows its parent
  };

  std::uint32_t
  divide (const Coordinates& points, std::uint32_t begin, std::uint32_t end);

  std::vector<Node> nodes_;
  Indices order_;
  Coordinates sorted_;
};

} // namespace pcl_ops::internal
