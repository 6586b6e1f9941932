// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "detection/neighbour_search.h"

#include "search/box_tree_builder.h"

#include <memory>

namespace pcl_ops::internal {

namespace {

NeighborSearch
ownSearch (const CloudView& cloud, const Points& points, unsigned threads)
{
  const auto tree = std::make_shared<const BoxTree> (buildBoxTree (points, cloud));
  const auto find = [tree, cloud] (pcl::index_t point,
                                   NeighborQuery query,
                                   pcl::Indices& neighbours,
                                   std::vector<float>& squared_distances) {
    const float* const position = cloud[static_cast<std::size_t> (point)];
    query.position = {position[0], position[1], position[2]};
    query.sorted = false;
    tree->find (query, neighbours, squared_distances);
  };
  NeighborSearch search;
  search.nearest =
      [find] (pcl::index_t point, int k, auto& neighbours, auto& distances) {
        NeighborQuery query;
        query.max_neighbors = static_cast<std::size_t> (k);
        find (point, query, neighbours, distances);
      };
  search.within =
      [find] (pcl::index_t point, double radius, auto& neighbours, auto& distances) {
        NeighborQuery query;
        query.squared_radius = static_cast<float> (radius * radius);
        find (point, query, neighbours, distances);
      };
  search.threads = threads;
  return search;
}

} // namespace

NeighborSearch
searchOver (const DetectorInput& input, const Points& points, unsigned threads)
{
  return input.search_over ? input.search_over (points.index)
                           : ownSearch (input.cloud, points, threads);
}

} // namespace pcl_ops::internal
