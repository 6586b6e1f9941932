// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/types.h>

#include "geometry/points.h"
#include <pcl_ops/detail/neighbor_query.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl_ops::internal {

/** \brief A tree of boxes over points, in which the neighbours of any position are
 * found exactly. Once built it never changes: any number of threads may search it. */
class BoxTree {
public:
  static constexpr std::size_t most_children = 8;
  /** \brief Leaves have fewer points, or as many: their distances are computed at once.
   */
  static constexpr std::uint32_t most_points_of_leaf = 64;

  using OfChildren = std::array<float, most_children>;

  /** \brief Where the points of a child are. */
  struct Child {
    /** \brief Position of a leaf's first point, or number of a node. */
    std::uint32_t first = 0;
    /** \brief Number of a leaf's points; 0: a node. */
    std::uint32_t size = 0;
  };

  /** \brief The bounding boxes of all children side by side: one loop tests them. */
  struct Node {
    OfChildren low_x, low_y, low_z, high_x, high_y, high_z;
    std::array<Child, most_children> children;
    std::uint32_t number = 0;
  };

  BoxTree() = default;

  /** \param[in] nodes the root first, each before those below it
   * \param[in] points leaf after leaf
   * \param[in] index of each point in its cloud */
  BoxTree (std::vector<Node> nodes, Coordinates points, pcl::Indices index);

  /** \brief Number of points. */
  std::size_t
  size () const
  {
    return index_.size();
  }

  /** \brief Finds the nearest points within the radius. Which of several at the same
   * distance as the farthest one are found depends on the points and the query alone.
   * \param[in] query its position is finite
   * \param[out] indices of the neighbours; what it held is replaced
   * \param[out] squared_distances in single precision, as PCL computes them [m^2] */
  void
  find (const NeighborQuery& query,
        pcl::Indices& indices,
        std::vector<float>& squared_distances) const;

private:
  std::vector<Node> nodes_;
  Coordinates points_;
  pcl::Indices index_;
};

} // namespace pcl_ops::internal
