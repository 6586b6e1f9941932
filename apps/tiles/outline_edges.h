// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <vector>

namespace pcl_ops::apps {

/** \brief A point of the lattice with the spacing \ref outlineUnit, in the frame of the
 * inputs: x, y and z in units of that spacing. */
using LatticePoint = std::array<std::int64_t, 3>;

/** \brief An edge of an outline, with the plane to its left for a viewer on the side
 * that the normal points to. */
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
 * 1.5 edges of a cell, or 3 or 6 if the points in the tile are sparse.
 *
 * Each triangle belongs to the tile of its first corner by coordinates. Along a border
 * of tiles both tiles return the same edges in opposite directions. If these are left
 * out, the edges of all tiles are the outline of the whole plane. Away from the outline
 * and from borders of tiles, points are first thinned to one per square as wide as a
 * cell.
 * \param[in] points all points on the plane in a tile and its halo, in any order
 * \param[in] normal of the plane: the side from which it is to the left of the edges
 * \param[in] cell_edge edge of a cell [spacing of the lattice] */
std::vector<OutlineEdge>
outlineEdges (const std::vector<OutlinePoint>& points,
              const Eigen::Vector3d& normal,
              double cell_edge);

} // namespace pcl_ops::apps
