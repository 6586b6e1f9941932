// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <pcl_ops/plane_extent.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace pcl_ops::internal {

constexpr std::size_t octants = 8;
constexpr std::uint32_t no_neighbor = std::numeric_limits<std::uint32_t>::max();

/** \brief Returns the octant of a direction, an eighth of a full turn: 0 to 7,
 * counterclockwise from the x axis. Octants of opposite directions differ by four.
 * \param[in] direction not the zero vector */
std::size_t
octantOf (const Eigen::Vector2d& direction);

/** \brief The nearest point in each octant around a position. */
struct OctantNeighbors {
  /** \brief Indices, or \ref no_neighbor at an infinite distance. */
  std::array<std::uint32_t, octants> points;
  std::array<double, octants> squared_distances;
};

/** \brief A 2D k-d tree that finds the nearest point in each octant. So a point on a
 * lidar ring has neighbors on its own ring and on the rings beside it, however far
 * apart the rings are. The pieces of a plane (plane_pieces.h) are sets of points that
 * are connected through these neighbors. */
class OctantTree {
public:
  /** \param[in] points all different; the tree keeps a reference to them */
  explicit OctantTree (const PlanarPoints& points);

  /** \brief Returns the neighbors of the point with index \p point. */
  OctantNeighbors
  neighborsOf (std::uint32_t point) const;

  /** \brief A few points near one another: those of a leaf. */
  struct Group {
    /** \brief Indices, ascending. */
    std::vector<std::uint32_t> points;
    Eigen::Vector2d center;
    /** \brief The nearest points of other groups around the center. */
    OctantNeighbors neighbors;
  };

  /** \brief Divides the points into groups. The groups depend on the coordinates alone,
   * not on the order of the points. */
  std::vector<Group>
  groups (unsigned threads) const;

private:
  struct Node {
    Eigen::Array2d low, high; // corners of the bounding box
    std::uint32_t begin, end; // of its points in \ref order_
    /** \brief Index of the second child, 0: leaf. The first child is the next node. */
    std::uint32_t second_child = 0;
  };

  // Adds a node over the points order_[begin] .. order_[end - 1], and those below it.
  void
  build (std::uint32_t begin, std::uint32_t end);

  /** \brief Searches the points of a node for nearer neighbors.
   * \param[in] skipped_node index of a node; nodes_.size(): skip no node */
  void
  search (std::size_t node_index,
          const Eigen::Vector2d& position,
          std::size_t skipped_node,
          OctantNeighbors& nearest) const;

  OctantNeighbors
  neighborsAt (const Eigen::Vector2d& position, std::size_t skipped_node) const;

  const PlanarPoints& points_;
  /** \brief Indices of the points, leaf by leaf. */
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
};

} // namespace pcl_ops::internal
