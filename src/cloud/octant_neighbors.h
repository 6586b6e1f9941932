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
  /** \brief Indices of the points; \ref no_neighbor for an octant without points. */
  std::array<std::uint32_t, octants> points;
  /** \brief From the position to the points [m^2]; infinite for an octant without
   * points. */
  std::array<double, octants> squared_distances;
};

/** \brief A 2D k-d tree that finds the nearest point in each octant. So a point on a
 * lidar ring has neighbors on its own ring and on the rings beside it, however far
 * apart the rings are. The pieces of a plane (plane_pieces.h) are sets of points that
 * are connected through these neighbors. */
class OctantTree {
public:
  /** \param[in] points all different [m]; the tree keeps a reference to them */
  explicit OctantTree (const PlanarPoints& points);

  /** \brief Returns the neighbors of the point with index \p point, without the point
   * itself. */
  OctantNeighbors
  neighborsOf (std::uint32_t point) const;

  /** \brief A few points near one another: those of a leaf of the tree. */
  struct Group {
    /** \brief Indices, ascending. */
    std::vector<std::uint32_t> points;
    Eigen::Vector2d center; // mean of the points
    /** \brief The nearest points of other groups around the center. */
    OctantNeighbors neighbors;
  };

  /** \brief Divides the points into groups. Which points are a group depends on the
   * coordinates alone; the order of the points may change the last digit of its center.
   * \param[in] threads largest number of threads; 0: one for each processor */
  std::vector<Group>
  groups (unsigned threads) const;

private:
  struct Node {
    Eigen::Array2d low, high; // corners of the bounding box
    std::uint32_t begin, end; // of its points in \ref order_
    /** \brief Index of the second child in \ref nodes_; 0 for a leaf. The first child
     * is the next node. */
    std::uint32_t second_child = 0;
  };

  // Adds a node over the points order_[begin] .. order_[end - 1], and those below it.
  void
  build (std::uint32_t begin, std::uint32_t end);

  /** \brief Searches the points of a node for neighbors of a position that are nearer
   * than those in \p nearest.
   * \param[in] skipped_node index of a node; nodes_.size(): skip no node */
  void
  search (std::size_t node_index,
          const Eigen::Vector2d& position,
          std::size_t skipped_node,
          OctantNeighbors& nearest) const;

  /** \brief Returns the neighbors of a position among the points outside of a node.
   * \param[in] skipped_node as for \ref search */
  OctantNeighbors
  neighborsAt (const Eigen::Vector2d& position, std::size_t skipped_node) const;

  const PlanarPoints& points_;
  /** \brief Indices of the points, leaf by leaf. */
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
};

} // namespace pcl_ops::internal
