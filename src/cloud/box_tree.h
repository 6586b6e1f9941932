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

/** \brief A tree of bounding boxes for exact nearest neighbor and radius search around
 * any position. It never changes once built, so any number of threads may search it. */
class BoxTree {
public:
  /** \brief A node divides its points three times into two, so that few nodes have to
   * be visited. */
  static constexpr std::size_t max_children = 8;
  /** \brief Largest number of points of a leaf; a search computes the distances of all
   * of them at once. Chosen by hand, changes only the time. */
  static constexpr std::uint32_t max_points_of_leaf = 40;

  /** \brief A child of a node: a leaf or another node. */
  struct Child {
    /** \brief Of a leaf: index of its first point in points_. Of a node: its index in
     * nodes_. */
    std::uint32_t first = 0;
    /** \brief Of a leaf: number of its points. Of a node: 0. */
    std::uint32_t size = 0;
  };

  /** \brief A node stores the bounding boxes of its children, one row each, so that one
   * vectorized loop tests all of them. */
  struct Node {
    Eigen::Array<float, max_children, 3> low, high;
    std::array<Child, max_children> children;
    /** \brief For each child, the lowest index that one of its points has in the cloud.
     */
    std::array<pcl::index_t, max_children> lowest_index;
    std::uint32_t child_count = 0;
  };

  /** \param[in] points the finite points of \p cloud; only their indices are used
   * \param[in] cloud the cloud of these points. Queries and distances are in its frame,
   * so that distances have no rounding error of the local frame (Points::origin). The
   * tree keeps no reference to the cloud. */
  BoxTree (const Points& points, const CloudView& cloud);

  /** \brief Finds the nearest points within the radius of the query. Of several points
   * at the same distance it takes those with the lowest indices.
   * \param[in] query must have a finite position
   * \param[out] indices of the neighbors in the cloud; former contents are replaced
   * \param[out] squared_distances in single precision, as PCL computes them [m^2] */
  void
  find (const NeighborQuery& query,
        pcl::Indices& indices,
        std::vector<float>& squared_distances) const;

private:
  /** \brief The root comes first, and each node before the nodes below it. */
  std::vector<Node> nodes_;
  /** \brief The points, leaf by leaf, in the frame of the cloud. */
  Coordinates points_;
  /** \brief For each of \ref points_ the index in the cloud. */
  pcl::Indices index_;
};

} // namespace pcl_ops::internal
