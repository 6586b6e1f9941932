// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/grid_search.h>

#include <algorithm>
#include <numeric>

namespace pcl_ops {

template <typename PointT>
GridSearch<PointT>::GridSearch (bool sorted) : Base ("GridSearch", sorted)
{}

template <typename PointT>
typename GridSearch<PointT>::Accepted
GridSearch<PointT>::setInputCloud (const PointCloudConstPtr& cloud,
                                   const IndicesConstPtr& indices)
{
  pcl::Indices used;
  if (indices)
    used = *indices;
  else if (cloud) {
    used.resize (cloud->size());
    std::iota (used.begin(), used.end(), 0);
  }
  tree_ = cloud ? detail::buildBoxTree (CloudView (*cloud), used) : nullptr;
  return Base::setInputCloud (cloud, indices);
}

template <typename PointT>
int
GridSearch<PointT>::find (const PointT& point,
                          detail::NeighborQuery query,
                          pcl::Indices& indices,
                          std::vector<float>& squared_distances) const
{
  query.position = point.getVector3fMap();
  query.sorted = this->sorted_results_;
  detail::findNeighbors (tree_.get(), query, indices, squared_distances);
  return static_cast<int> (indices.size());
}

template <typename PointT>
int
GridSearch<PointT>::nearestKSearch (const PointT& point,
                                    int k,
                                    pcl::Indices& k_indices,
                                    std::vector<float>& k_sqr_distances) const
{
  detail::NeighborQuery query;
  query.max_neighbors = static_cast<std::size_t> (std::max (k, 0));
  return find (point, query, k_indices, k_sqr_distances);
}

template <typename PointT>
int
GridSearch<PointT>::radiusSearch (const PointT& point,
                                  double radius,
                                  pcl::Indices& k_indices,
                                  std::vector<float>& k_sqr_distances,
                                  unsigned int max_nn) const
{
  detail::NeighborQuery query;
  query.squared_radius = static_cast<float> (radius * radius);
  if (max_nn > 0)
    query.max_neighbors = max_nn;
  if (!(radius >= 0.0))
    query.max_neighbors = 0;
  return find (point, query, k_indices, k_sqr_distances);
}

} // namespace pcl_ops

#define PCL_INSTANTIATE_GridSearch(T)                                                  \
  template class PCL_OPS_EXPORT pcl_ops::GridSearch<T>;
