// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/search/search.h>

#include <pcl_ops/detail/neighbor_query.h>
#include <pcl_ops/export.h>

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

namespace pcl_ops {

/** \brief Exact search for nearest neighbors and within a radius, for all users of
 * pcl::search, in a tree of bounding boxes. (It is named after the grid of its first
 * version.) Building the tree takes about a third of the time of pcl::KdTreeFLANN,
 * which saves most if only few points are searched for.
 *
 * Points with a NaN or infinite coordinate are left out. Distances are equal to those
 * of pcl::search::KdTree to the last bit. Neighbors at the same distance are sorted by
 * index. Several threads may search at the same time.
 * \tparam PointT a point type with x, y, z */
template <typename PointT>
class GridSearch : public pcl::search::Search<PointT> {
public:
  using Base = pcl::search::Search<PointT>;
  using PointCloud = typename Base::PointCloud;
  using PointCloudConstPtr = typename Base::PointCloudConstPtr;
  using IndicesConstPtr = typename Base::IndicesConstPtr;
  using Ptr = pcl::shared_ptr<GridSearch<PointT>>;
  using ConstPtr = pcl::shared_ptr<const GridSearch<PointT>>;
  /** \brief Return type of setInputCloud: void or bool, depending on PCL's version. */
  using Accepted = decltype (std::declval<Base&>().setInputCloud (nullptr));

  using Base::nearestKSearch;
  using Base::radiusSearch;

  /** \param[in] sorted whether neighbors are sorted by distance */
  explicit GridSearch (bool sorted = true) : Base ("GridSearch", sorted) {}

  /** \brief Builds the tree. Later changes of the cloud have no effect.
   * \param[in] cloud the cloud whose indices searches return
   * \param[in] indices of the points to search among, all valid; null: all points */
  Accepted
  setInputCloud (const PointCloudConstPtr& cloud,
                 const IndicesConstPtr& indices = IndicesConstPtr()) override
  {
    tree_ = cloud ? detail::buildBoxTree (CloudView (*cloud), indices.get()) : nullptr;
    return Base::setInputCloud (cloud, indices);
  }

  /** \brief Finds the k nearest points, or all if the input has fewer than k.
   * \return number of neighbors; 0 without an input cloud or if the point is not finite
   */
  int
  nearestKSearch (const PointT& point,
                  int k,
                  pcl::Indices& k_indices,
                  std::vector<float>& k_sqr_distances) const override
  {
    detail::NeighborQuery query;
    query.max_neighbors = static_cast<std::size_t> (std::max (k, 0));
    return find (point, query, k_indices, k_sqr_distances);
  }

  /** \brief Finds the points within a radius; only the nearest max_nn of them if max_nn
   * is not 0.
   * \return number of neighbors; 0 without an input cloud, if the point is not finite,
   * or if the radius is negative or NaN */
  int
  radiusSearch (const PointT& point,
                double radius,
                pcl::Indices& k_indices,
                std::vector<float>& k_sqr_distances,
                unsigned int max_nn = 0) const override
  {
    detail::NeighborQuery query;
    query.squared_radius = static_cast<float> (radius * radius);
    if (max_nn > 0)
      query.max_neighbors = max_nn;
    if (!(radius >= 0.0))
      query.max_neighbors = 0;
    return find (point, query, k_indices, k_sqr_distances);
  }

private:
  int
  find (const PointT& point,
        detail::NeighborQuery query,
        pcl::Indices& indices,
        std::vector<float>& squared_distances) const
  {
    query.position = point.getVector3fMap();
    query.sorted = this->sorted_results_;
    detail::findNeighbors (tree_.get(), query, indices, squared_distances);
    return static_cast<int> (indices.size());
  }

  std::shared_ptr<const internal::BoxTree> tree_;
};

} // namespace pcl_ops

#ifdef PCL_NO_PRECOMPILE
#include <pcl_ops/impl/grid_search.hpp>
#endif
