// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <pcl_ops/plane_extent.h>

#include <array>
#include <cstdint>
#include <vector>

namespace pcl_ops::apps {

/** \brief A place on the lattice of \ref outlineUnit, in the frame of the inputs. */
using LatticePlace = std::array<std::int64_t, 3>;

struct OutlineEdge {
  LatticePlace from{}, to{}; // the plane is to the left
};

/** \brief A point on a plane that a tile sees. */
struct OutlinePoint {
  LatticePlace place{};
  /** \brief Whether it is in the tile itself, not in its halo. */
  bool is_own = false;
};

/** \brief Spacing of the lattice of outlines [m]: about a hundredth of a cell. */
double
outlineUnit (double cell);

/** \brief A tile's share of the boundary edges of a plane's alpha shape (Edelsbrunner,
 * Kirkpatrick & Seidel, On the shape of a set of points in the plane, 1983): of the
 * Delaunay triangles with a circumradius of one and a half cells at most, or more where
 * points are sparse.
 *
 * Each triangle belongs to the tile that owns its first point. Along the border two
 * tiles return the same edges in opposite directions. These cancel, and the edges left
 * of all tiles are the outline of the whole plane. Away from the rim and from borders,
 * points are first thinned to one per square of the size of a cell.
 * \param[in] points all points on the plane in a tile and its halo
 * \param[in] normal on the side from which the plane is to the left of its edges
 * \param[in] cell edge of a cell [lattice places] */
std::vector<OutlineEdge>
outlineEdges (const std::vector<OutlinePoint>& points,
              const Eigen::Vector3d& normal,
              double cell);

/** \brief The parts of a plane, each with its holes, by falling area. On average the
 * outermost points are 0.3 of their spacing inside the plane's edge; corners are moved
 * out by that distance.
 * \param[in] edges of all tiles; opposite ones cancel
 * \param[in] frame of the plane, seen from where the plane is to the left of the edges
 * \param[in] unit of the lattice [m]
 * \param[in] points number of points on the plane, which gives their spacing
 * \param[in] min_area of a hole, and of a part other than the largest [m^2] */
std::vector<PlanarRings>
outlineOf (const std::vector<OutlineEdge>& edges,
           const PlaneFrame& frame,
           double unit,
           double points,
           double min_area);

} // namespace pcl_ops::apps
