// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/types.h>

#include <Eigen/Core>

#include "cloud/points.h"
#include <pcl_ops/detail/neighbor_query.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl_ops::internal {

/** \brief A tree of boxes over points that finds the neighbors of any position exactly.
 * Once built it never changes, so that any number of threads may search it. */
class BoxTree {
public:
  static constexpr std::size_t max_children = 8;
  /** \brief A leaf has up to so many points, whose distances are computed at once. */
  static constexpr std::uint32_t max_points_of_leaf = 40;

  /** \brief Where the points of a child are. */
  struct Child {
    /** \brief Position of a leaf's first point, or number of a node. */
    std::uint32_t first = 0;
    /** \brief Number of a leaf's points; 0: a node. */
    std::uint32_t size = 0;
  };

  /** \brief A node has the bounding boxes of its children, a row each: one loop tests
   * them all. */
  struct Node {
    Eigen::Array<float, max_children, 3> low, high;
    std::array<Child, max_children> children;
    /** \brief For each child, the lowest index of its points. */
    std::array<pcl::index_t, max_children> lowest_index;
    std::uint32_t number = 0;
  };

  /** \param[in] points finite points in their local frame
   * \param[in] cloud the cloud of these points. Queries and distances are in its frame,
   * so that rounding to another frame does not change distances. The tree keeps no
   * reference to it. */
  BoxTree (const Points& points, const CloudView& cloud);

  /** \brief Finds the nearest points within the radius. Of several points at the same
   * distance it takes those with the lowest indices.
   * \param[in] query its position is finite
   * \param[out] indices of the neighbors; what it held is replaced
   * \param[out] squared_distances in single precision, as PCL computes them [m^2] */
  void
  find (const NeighborQuery& query,
        pcl::Indices& indices,
        std::vector<float>& squared_distances) const;

private:
  /** \brief The root comes first, and each node comes before those below it. */
  std::vector<Node> nodes_;
  /** \brief Leaf after leaf, in the frame of the cloud. */
  Coordinates points_;
  pcl::Indices index_;
};

} // namespace pcl_ops::internal
