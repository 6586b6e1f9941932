// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/search/search.h>

#include <Eigen/Core>

#include <pcl_ops/cloud_view.h>
#include <pcl_ops/export.h>

#include <limits>
#include <memory>
#include <type_traits>
#include <vector>

namespace pcl_ops {

namespace internal {
class BoxTree;
}

/** \brief Which neighbours are asked for. */
struct NeighbourQuery {
  Eigen::Vector3f position = Eigen::Vector3f::Zero();
  /** \brief k: most neighbours, the nearest ones. */
  std::size_t most = std::numeric_limits<std::size_t>::max();
  /** \brief Largest squared distance of a neighbour [m^2]. */
  float squared_radius = std::numeric_limits<float>::infinity();
  /** \brief Whether neighbours come by rising distance, equal ones by rising index. */
  bool sorted = true;
};

/** \brief GridSearch for a cloud of any point type: sorts the finite ones of some
 * points into voxels. \param[in] cloud not needed afterwards \param[in] indices the
 * points to search among, each within the cloud */
PCL_OPS_EXPORT std::shared_ptr<const internal::BoxTree>
sortIntoVoxels (const CloudView& cloud, const pcl::Indices& indices);

/** \brief Finds the nearest points within a radius.
 * \param[in] tree what \ref sortIntoVoxels gave; nothing is found where there is none
 * \param[in] query nothing is found where its position is not finite
 * \param[out] indices of the neighbours in the cloud
 * \param[out] squared_distances [m^2] */
PCL_OPS_EXPORT void
findNeighbours (const internal::BoxTree* tree,
                const NeighbourQuery& query,
                pcl::Indices& indices,
                std::vector<float>& squared_distances);

/** \brief Exact nearest neighbours and radius search for any user of PCL, built in
 * about a third of the time of pcl::KdTreeFLANN: worth most where few of the points are
 * asked for.
 *
 * Points are sorted into the voxels of a uniform grid whose resolution follows the
 * cloud and searched by a tree of boxes. Points with a NaN or infinite coordinate are
 * left out. Distances are those of pcl::search::KdTree to the last bit; neighbours at
 * the same distance come by their index. Any number of threads may search at once.
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
  /** \brief void or bool, as the version of PCL has it. */
  using Accepted = decltype (std::declval<Base&>().setInputCloud (nullptr));

  using Base::nearestKSearch;
  using Base::radiusSearch;

  /** \param[in] sorted whether neighbours come by rising distance, as setSortedResults
   */
  explicit GridSearch (bool sorted = true);

  /** \brief Sorts the points of a cloud into voxels; later changes of the cloud are not
   * seen.
   * \param[in] cloud the cloud that results are indices into
   * \param[in] indices the points to search among, each within the cloud; none: all */
  Accepted
  setInputCloud (const PointCloudConstPtr& cloud,
                 const IndicesConstPtr& indices = IndicesConstPtr()) override;

  /** \brief Finds the nearest points.
   * \param[in] point any position
   * \param[in] k most neighbours; fewer are found where the input has fewer
   * \param[out] k_indices of the neighbours in the input cloud
   * \param[out] k_sqr_distances [m^2]
   * \return the number found; 0 without input or for a point that is not finite */
  int
  nearestKSearch (const PointT& point,
                  int k,
                  pcl::Indices& k_indices,
                  std::vector<float>& k_sqr_distances) const override;

  /** \brief Finds the points at most a radius away.
   * \param[in] point any position
   * \param[in] radius [m]
   * \param[out] k_indices of the neighbours in the input cloud
   * \param[out] k_sqr_distances [m^2]
   * \param[in] max_nn most neighbours, the nearest ones; 0: all
   * \return the number found; 0 without input, for a point that is not finite or a
   * radius below 0 */
  int
  radiusSearch (const PointT& point,
                double radius,
                pcl::Indices& k_indices,
                std::vector<float>& k_sqr_distances,
                unsigned int max_nn = 0) const override;

private:
  int
  find (const PointT& point,
        NeighbourQuery query,
        pcl::Indices& indices,
        std::vector<float>& squared_distances) const;

  std::shared_ptr<const internal::BoxTree> tree_;
};

} // namespace pcl_ops

#ifdef PCL_NO_PRECOMPILE
#include <pcl_ops/impl/grid_search.hpp>
#endif
