// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "detection/neighbour_search.h"

#include "search/box_tree_builder.h"

#include <memory>

namespace pcl_ops::internal {

NeighborSearch
searchOver (const DetectorInput& input, const Points& points, unsigned threads)
{
  if (input.search_over)
    return input.search_over (points.index);
  const auto tree =
      std::make_shared<const BoxTree> (buildBoxTree (points, input.cloud));
  NeighborSearch search;
  search.nearest = [tree, cloud = input.cloud] (pcl::index_t point,
                                                int k,
                                                pcl::Indices& neighbours,
                                                std::vector<float>& squared_distances) {
    const float* const position = cloud[static_cast<std::size_t> (point)];
    NeighborQuery query;
    query.position = {position[0], position[1], position[2]};
    query.max_neighbors = static_cast<std::size_t> (k);
    query.sorted = false;
    tree->find (query, neighbours, squared_distances);
  };
  search.threads = threads;
  return search;
}

} // namespace pcl_ops::internal
