// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/types.h>

#include <Eigen/Core>

#include <pcl_ops/cloud_view.h>
#include <pcl_ops/export.h>

#include <cstddef>
#include <limits>
#include <memory>
#include <vector>

namespace pcl_ops::internal {
class BoxTree;
}

namespace pcl_ops::detail {

/** \brief Describes the neighbors to find. */
struct NeighborQuery {
  Eigen::Vector3f position = Eigen::Vector3f::Zero();
  /** \brief k: the largest number of neighbors; farther ones are left out. */
  std::size_t max_neighbors = std::numeric_limits<std::size_t>::max();
  /** \brief Largest squared distance of a neighbor [m^2]. */
  float squared_radius = std::numeric_limits<float>::infinity();
  /** \brief Whether neighbors are sorted by distance, and by index at equal distances.
   */
  bool sorted = true;
};

/** \brief Builds the bounding box tree of GridSearch over the finite points of a cloud
 * of any point type. It copies the positions: the cloud may be deleted afterwards.
 * \param[in] indices the points to use; null: all */
PCL_OPS_EXPORT std::shared_ptr<const internal::BoxTree>
buildBoxTree (const CloudView& cloud, const pcl::Indices* indices);

/** \brief Finds the nearest points within a radius, with their squared distances [m^2].
 * Both outputs are empty if the tree is null or the position is not finite. */
PCL_OPS_EXPORT void
findNeighbors (const internal::BoxTree* tree,
               const NeighborQuery& query,
               pcl::Indices& indices,
               std::vector<float>& squared_distances);

} // namespace pcl_ops::detail
