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

/** \brief Which neighbors are asked for. */
struct NeighborQuery {
  Eigen::Vector3f position = Eigen::Vector3f::Zero();
  /** \brief k: most neighbors, the nearest ones. */
  std::size_t max_neighbors = std::numeric_limits<std::size_t>::max();
  /** \brief Largest squared distance of a neighbor [m^2]. */
  float squared_radius = std::numeric_limits<float>::infinity();
  /** \brief Whether neighbors come by rising distance, equal ones by rising index. */
  bool sorted = true;
};

/** \brief GridSearch for a cloud of any point type, which is not needed afterwards:
 * builds a tree of boxes over the finite ones of some points, or of all. */
PCL_OPS_EXPORT std::shared_ptr<const internal::BoxTree>
buildBoxTree (const CloudView& cloud, const pcl::Indices* indices);

/** \brief Finds the nearest points within a radius, with their squared distances [m^2];
 * nothing without a tree or a finite position. */
PCL_OPS_EXPORT void
findNeighbors (const internal::BoxTree* tree,
               const NeighborQuery& query,
               pcl::Indices& indices,
               std::vector<float>& squared_distances);

} // namespace pcl_ops::detail
