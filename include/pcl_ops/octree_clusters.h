// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/plane.h>
#include <pcl_ops/points.h>

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
  /** \brief Nodes of this level are not split any more, so that many equal points end. */
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
  /** \brief Its points are order[begin] .. order[end - 1] of \ref OctreeClusters. */
  std::uint32_t begin = 0, end = 0;

  std::size_t
  size () const
  {
    return end - begin;
  }
};

/** \brief All clusters of a cloud. */
struct OctreeClusters {
  /** \brief Centroid of all points, the centre of the root cube. */
  Eigen::Vector3d centre = Eigen::Vector3d::Zero ();
  /** \brief Edge of the root cube: 2 max |coordinate about the centre| [m]. */
  double root_edge = 0.0;
  /** \brief rho_max: largest distance of a point to the centre [m]. */
  double radius = 0.0;
  std::vector<CoplanarCluster> clusters;
  /** \brief The positions of all points, permuted so that each node is a range. */
  Positions order;
};

/** \brief Splits the cloud's bounding cube in eight until the points of a node lie near a
 * plane or are too few. From the first level on, a node whose covariance passes the test
 * drops the points farther than a tenth of its edge from its plane and becomes a cluster.
 * \param[in] points finite positions
 * \param[in] parameters when to stop
 * \param[in] threads number of threads; 0: all. The result does not depend on it
 * \return the clusters in Morton order of the first levels; none for an empty cloud or
 * one whose points are all equal */
OctreeClusters
findCoplanarClusters (const Coordinates& points,
                      const OctreeClusterParameters& parameters,
                      unsigned threads = 1);

} // namespace pcl_ops
