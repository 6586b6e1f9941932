// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kht/sorted_octree.h"
#include <pcl_ops/kernel_hough_transform.h>
#include <pcl_ops/plane.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl_ops::internal {

using OctreeClusterParameters = KernelHoughTransformParameters::Clusters;

/** \brief The approximately coplanar points of one octree node. */
struct CoplanarCluster {
  /** \brief Their plane, centroid and variances, in the frame of the points. */
  PlaneFit fit;
  Moments moments;
  /** \brief Length of the node's edge [m]. */
  double edge = 0.0;
  int level = 0;
  /** \brief Its points are those from begin to before end of the permuted points. */
  std::uint32_t begin = 0, end = 0;

  std::size_t
  size () const
  {
    return end - begin;
  }
};

/** \brief All clusters of a cloud. */
struct OctreeClusters {
  RootCube root;
  std::vector<CoplanarCluster> clusters;
  /** \brief All points, in an order that makes each node a range; empty where the root
   * cube has no edge. */
  PermutedPoints points;
};

/** \brief Splits the cloud's bounding cube in eight until the points of a node lie near
 * a plane or are too few. From the first level on, a node whose covariance passes the
 * test drops the points farther than a tenth of its edge from its plane and becomes a
 * cluster. \param[in] points finite positions \param[in] parameters when to stop
 * \param[in] threads number of threads; 0: all. The result does not depend on it
 * \return the clusters in Morton order of the first levels; none for an empty cloud or
 * one whose points are all equal */
OctreeClusters
findCoplanarClusters (const Coordinates& points,
                      const OctreeClusterParameters& parameters,
                      unsigned threads = 1);

} // namespace pcl_ops::internal
