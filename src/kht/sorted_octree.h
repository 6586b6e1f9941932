// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "geometry/points.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl_ops::internal {

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
 * as its distance. \return edge 0 for no points */
RootCube
rootCubeOf (const Coordinates& points);

/** \brief Points in an order of their own. */
struct PermutedPoints : Coordinates {
  /** \brief The position each point had before. */
  Indices order;

  void
  resize (std::size_t size);

  void
  copyFrom (const PermutedPoints& other, std::size_t from, std::size_t to)
  {
    x[to] = other.x[from];
    y[to] = other.y[from];
    z[to] = other.z[from];
    order[to] = other.order[from];
  }

  void
  swapPoints (std::size_t i, std::size_t j);
};

/** \brief A range of points in a cube: a node of the octree. */
struct OctreeNode {
  std::uint32_t begin = 0, end = 0;
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  /** \brief Length of its edge [m]. */
  double edge = 0.0;
  /** \brief 0 for the root. */
  int level = 0;

  std::size_t
  size () const
  {
    return end - begin;
  }
};

/** \brief The octree's nodes down to a level, empty ones included. A node's code is its
 * place in Morton order among the nodes of its level; its children's are 8 code .. 8
 * code
 * + 7. */
struct SortedOctree {
  RootCube root;
  /** \brief The deepest level. */
  int level = 0;
  /** \brief The points, each node's together, and after them those outside the root. */
  PermutedPoints points;
  /** \brief Where each node of the deepest level begins in \ref points, and where the
   * last one ends. */
  std::vector<std::uint32_t> begins;

  /** \brief A node of the deepest level or above. */
  OctreeNode
  node (int node_level, std::size_t code) const;
};

/** \brief The deepest level \ref sortIntoOctree goes to: 8^5 leaves fit a 16 bit code
 * and the second level cache. */
constexpr int deepest_sorted_level = 5;

/** \brief Sorts the points into the octree's nodes of a level at once, by counting.
 * \param[in] points positions; those outside the cube go into no node
 * \param[in] root the cube, with an edge above 0
 * \param[in] level 0 .. deepest_sorted_level */
SortedOctree
sortIntoOctree (const Coordinates& points, const RootCube& root, int level);

} // namespace pcl_ops::internal
