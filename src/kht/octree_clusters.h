// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/octree_cells.h>
#include <pcl_ops/plane.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl_ops {

/** \brief What makes an octree node a cluster of approximately coplanar points
 * (Limberger & Oliveira 2015, section 3.1). */
struct OctreeClusterParameters {
  /** \brief Nodes with fewer points are not used. */
  std::size_t min_samples = 30;
  /** \brief s_level: the first level whose nodes are tested; the root is level 0. */
  int first_level = 5;
  /** \brief s_alpha: the thickness l1 / l2 of a coplanar node is below 1 / s_alpha. */
  double s_alpha = 25.0;
  /** \brief s_beta: the elongation l2 / l3 of a coplanar node is above 1 / s_beta. */
  double s_beta = 6.0;
  /** \brief Nodes of this level are not split any more, so that many equal points end.
   */
  int deepest_level = 20;
};

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

} // namespace pcl_ops
