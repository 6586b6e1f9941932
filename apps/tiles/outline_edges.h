// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <vector>

namespace pcl_ops::apps {

/** \brief A point of the lattice of \ref outlineUnit, in the frame of the inputs: x, y
 * and z in units of the lattice. */
using LatticePoint = std::array<std::int64_t, 3>;

/** \brief An edge of an outline. The plane is to its left. */
struct OutlineEdge {
  LatticePoint from{}, to{};
};

/** \brief A point on a plane that a tile sees. */
struct OutlinePoint {
  LatticePoint position{};
  /** \brief Whether it is in the tile itself, not in its halo. */
  bool is_own = false;
};

/** \brief Returns the spacing of the lattice of outlines [m]: about a hundredth of the
 * edge of a cell. */
double
outlineUnit (double cell_edge);

/** \brief Returns a tile's share of the outline of a plane. The outline is the boundary
 * of an alpha shape (Edelsbrunner, Kirkpatrick & Seidel, On the shape of a set of
 * points in the plane, 1983): of the Delaunay triangles whose circumradius is at most
 * one and a half cells, or three or six if the points in the tile are sparse.
 *
 * Each triangle belongs to the tile of its first corner by coordinates. Along a border
 * of tiles both return the same edges in opposite directions. These cancel, and the
 * remaining edges of all tiles are the outline of the whole plane. Away from the
 * outline and from borders of tiles, points are first thinned to one per square as wide
 * as a cell.
 * \param[in] points all points on the plane in a tile and its halo, in any order
 * \param[in] normal to a viewer on the side that it points to, the plane lies to the
 * left of the returned edges
 * \param[in] cell_edge in units of the lattice */
std::vector<OutlineEdge>
outlineEdges (const std::vector<OutlinePoint>& points,
              const Eigen::Vector3d& normal,
              double cell_edge);

} // namespace pcl_ops::apps
