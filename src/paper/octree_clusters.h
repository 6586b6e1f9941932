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

/** \brief The cube an octree starts from. */
struct RootCube {
  /** \brief Centroid of the points that are not far from all others. */
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  /** \brief 2 max |coordinate about the center| of these points [m]; 0 for points that
   * are all equal. */
  double edge = 0.0;
  /** \brief Largest distance to the center of a point in the cube [m]. */
  double radius = 0.0;

  bool
  holds (const Eigen::Vector3d& point) const
  {
    return (point - center).cwiseAbs().maxCoeff() <= edge / 2.0;
  }
};

/** \brief The cube around the centroid that holds the points, but for those far from
 * all others: farther from the middle 96 per cent of a coordinate than those of the
 * widest coordinate spread. One stray return would else make the nodes as coarse
 * as its distance.
 * \return edge 0 for no points */
RootCube
rootCubeOf (const Coordinates& points);

/** \brief A point and its position in the cloud. */
struct OctreePoint {
  float x, y, z;
  std::uint32_t index;

  Eigen::Vector3d
  position () const
  {
    return Eigen::Vector3d (x, y, z);
  }
};

/** \brief The approximately coplanar points of one octree node. */
struct CoplanarCluster {
  /** \brief Their plane, centroid and variances, in the frame of the points. */
  PlaneFit fit;
  Moments moments;
  /** \brief Length of the node's edge [m]. */
  double edge = 0.0;
  int level = 0;
  /** \brief Its points are those from begin to before end of OctreeClusters::points. */
  std::uint32_t begin = 0, end = 0;

  std::size_t
  size () const
  {
    return end - begin;
  }
};

struct OctreeClusters {
  RootCube root;
  std::vector<CoplanarCluster> clusters;
  /** \brief All points, in an order that makes each node a range; after them those
   * outside the root. Empty where the root cube has no edge. */
  std::vector<OctreePoint> points;
};

/** \brief Splits the cloud's bounding cube in eight until the points of a node lie near
 * a plane or are too few. From the first level on, a node whose covariance passes the
 * test drops the points farther than a tenth of its edge from its plane and becomes a
 * cluster. The result does not depend on the number of threads.
 * \return the clusters in Morton order of the first levels; none for an empty cloud or
 * one whose points are all equal */
OctreeClusters
findCoplanarClusters (const Coordinates& points,
                      const OctreeClusterParameters& parameters,
                      unsigned threads = 1);

} // namespace pcl_ops::internal
