// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/types.h>

#include <Eigen/Core>

#include "geometry/points.h"
#include <pcl_ops/detail/neighbor_query.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl_ops::internal {

/** \brief A tree of boxes over points, in which the neighbors of any position are
 * found exactly. Once built it never changes: any number of threads may search it. */
class BoxTree {
public:
  static constexpr std::size_t max_children = 8;
  /** \brief Of leaves; the distances of their points are computed at once. */
  static constexpr std::uint32_t max_points_of_leaf = 40;

  /** \brief Where the points of a child are. */
  struct Child {
    /** \brief Position of a leaf's first point, or number of a node. */
    std::uint32_t first = 0;
    /** \brief Number of a leaf's points; 0: a node. */
    std::uint32_t size = 0;
  };

  /** \brief The bounding boxes of all children, a row each: one loop tests them. */
  struct Node {
    Eigen::Array<float, max_children, 3> low, high;
    std::array<Child, max_children> children;
    /** \brief The lowest index of the points of each. */
    std::array<pcl::index_t, max_children> lowest_index;
    std::uint32_t number = 0;
  };

  /** \param[in] points finite points in their local frame
   * \param[in] cloud where they come from: queries and distances are in its frame, so
   * that no rounding to another changes distances; not needed afterwards */
  BoxTree (const Points& points, const CloudView& cloud);

  /** \brief Finds the nearest points within the radius, of several at the same distance
   * those of the lowest indices.
   * \param[in] query its position is finite
   * \param[out] indices of the neighbors; what it held is replaced
   * \param[out] squared_distances in single precision, as PCL computes them [m^2] */
  void
  find (const NeighborQuery& query,
        pcl::Indices& indices,
        std::vector<float>& squared_distances) const;

private:
  /** \brief The root first, each before those below it. */
  std::vector<Node> nodes_;
  /** \brief Leaf after leaf, in the frame of the cloud. */
  Coordinates points_;
  pcl::Indices index_;
};

} // namespace pcl_ops::internal
