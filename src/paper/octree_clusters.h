// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud/points.h"
#include <pcl_ops/kernel_hough_transform.h>
#include <pcl_ops/plane.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl_ops::internal {

using OctreeClusterParameters = KernelHoughTransformParameters::Clusters;

/** \brief The root cube of an octree. */
struct RootCube {
  /** \brief Centroid of the points that are not outliers. */
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  /** \brief Twice the largest |coordinate - center| of the points that are not outliers
   * [m]; 0 if these points are all equal, or if it would be below 1e-30. */
  double edge = 0.0;
  /** \brief Largest distance of a point in the cube from the center [m]. */
  double radius = 0.0;

  bool
  holds (const Eigen::Vector3d& point) const
  {
    return (point - center).cwiseAbs().maxCoeff() <= edge / 2.0;
  }
};

/** \brief The smallest cube around the centroid that holds all points but outliers.
 * Each coordinate has a range, which holds the middle 96 percent of its values. A point
 * is an outlier if it lies farther outside one of the three ranges than the widest of
 * them is wide. If outliers were in the cube, one stray return would make all nodes
 * coarse.
 * \return edge 0 for no points */
RootCube
rootCubeOf (const Coordinates& points);

/** \brief A point, with its index in the points that the octree was built from. */
struct OctreePoint {
  float x, y, z;
  std::uint32_t index;

  Eigen::Vector3d
  position () const
  {
    return Eigen::Vector3d (x, y, z);
  }
};

/** \brief The roughly coplanar points of one octree node. */
struct CoplanarCluster {
  /** \brief Least squares fit to the points, in their frame. */
  PlaneFit fit;
  Moments moments;
  /** \brief Length of the node's edge [m]. */
  double edge = 0.0;
  /** \brief Level of the node; the root is level 0. */
  int level = 0;
  /** \brief Its points: the range [begin, end) of OctreeClusters::points. */
  std::uint32_t begin = 0, end = 0;

  std::size_t
  size () const
  {
    return end - begin;
  }
};

/** \brief The roughly coplanar parts of a cloud. */
struct OctreeClusters {
  RootCube root;
  std::vector<CoplanarCluster> clusters;
  /** \brief All points: first those in the root cube, in an order that makes each node
   * a range, then those outside. Empty if the edge of the root cube is 0. */
  std::vector<OctreePoint> points;
};

/** \brief Builds an octree over the root cube and collects its coplanar nodes. Nodes
 * are split until their points lie near a plane or are too few, down to max_level. From
 * first_level on, a node whose variances pass the test of s_alpha and s_beta is not
 * split any more. It becomes a cluster, without the points farther than a tenth of its
 * edge from its plane; it makes no cluster if the others span no plane. The result does
 * not depend on the number of threads.
 * \return the clusters in Morton order; no clusters for an empty cloud or one whose
 * points are all equal */
OctreeClusters
findCoplanarClusters (const Coordinates& points,
                      const OctreeClusterParameters& parameters,
                      unsigned threads = 1);

} // namespace pcl_ops::internal
