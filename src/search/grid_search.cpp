// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/points.h"
#include "search/box_tree.h"
#include <pcl_ops/detail/neighbor_query.h>

namespace pcl_ops::detail {

std::shared_ptr<const internal::BoxTree>
buildBoxTree (const CloudView& cloud, const pcl::Indices& indices)
{
  constexpr unsigned one_thread = 1;
  const internal::Points points = internal::finitePoints (cloud, indices, one_thread);
  return std::make_shared<const internal::BoxTree> (points, cloud);
}

void
findNeighbors (const internal::BoxTree* tree,
               const NeighborQuery& query,
               pcl::Indices& indices,
               std::vector<float>& squared_distances)
{
  indices.clear();
  squared_distances.clear();
  if (tree && query.position.allFinite())
    tree->find (query, indices, squared_distances);
}

} // namespace pcl_ops::detail
