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

/** \brief The number of the eighth of a full turn that holds a direction, counted
 * counter-clockwise from x. Opposite directions have numbers that differ by four.
 * \param[in] direction other than zero */
std::size_t
octantOf (const Eigen::Vector2d& direction);

/** \brief The nearest point in each octant around a point, if there is one. */
struct OctantNeighbors {
  std::array<std::uint32_t, octants> points;
  std::array<double, octants> squared_distances;
};

/** \brief A tree over points in a plane that finds the nearest one in each octant. So a
 * point on a ring of a lidar has neighbors on its own ring and on the rings beside it,
 * however far apart rings are. The pieces of a plane (plane_pieces.h) are its points
 * connected by such neighbors. */
class OctantTree {
public:
  /** \param[in] points no two of them equal; they have to live as long as the tree */
  explicit OctantTree (const PlanarPoints& points);

  /** \brief The neighbors of one of the points. */
  OctantNeighbors
  neighborsOf (std::uint32_t point) const;

  /** \brief A few points near one another, by rising numbers. */
  struct Group {
    std::vector<std::uint32_t> points;
    Eigen::Vector2d center;
    /** \brief Points around the center that are in other groups. */
    OctantNeighbors neighbors;
  };

  /** \brief Divides the points into groups, by their places alone: their order does not
   * matter. */
  std::vector<Group>
  groups (unsigned threads) const;

private:
  struct Node {
    Eigen::Array2d low, high;
    std::uint32_t begin, end;
    /** \brief Position of the second child, the first one being the next node; 0 for a
     * leaf. */
    std::uint32_t second = 0;
  };

  void
  build (std::uint32_t begin, std::uint32_t end);

  /** \param[in] left_out a node, or no node */
  void
  search (std::size_t node,
          const Eigen::Vector2d& place,
          std::size_t left_out,
          OctantNeighbors& nearest) const;

  OctantNeighbors
  neighborsAt (const Eigen::Vector2d& place, std::size_t left_out) const;

  const PlanarPoints& points_;
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
};

} // namespace pcl_ops::internal
