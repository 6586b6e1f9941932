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
  /** \brief Of the tile itself, not of its halo. */
  bool is_own = false;
};

/** \brief Edge of the lattice that outlines are on [m]: a hundredth of a cell. */
double
outlineUnit (double cell);

/** \brief A tile's share of the edges around a plane's alpha shape (Edelsbrunner,
 * Kirkpatrick & Seidel, On the shape of a set of points in the plane, 1983), which has
 * the triangles between neighboring points whose circumscribed circle has a radius of
 * one and a half cells at most, or more where points are few.
 *
 * Each triangle belongs to the tile that owns the first of its points, so that the
 * edges between tiles that both have vanish together: those that are left of all tiles
 * are the outline of the whole. Points with all cells around them taken are thinned to
 * one of a cell first.
 * \param[in] points all that a tile and its halo have on the plane
 * \param[in] normal towards where the plane is seen from: edges go round it to the left
 * \param[in] cell edge of a cell [lattice places] */
std::vector<OutlineEdge>
outlineEdges (const std::vector<OutlinePoint>& points,
              const Eigen::Vector3d& normal,
              double cell);

/** \brief The parts of a plane, each with its holes, by falling area. The outermost
 * points are within the plane's edge by a third of their spacing in the mean; corners
 * are moved out by as much.
 * \param[in] edges of all tiles; of two that are opposite none is left
 * \param[in] frame in the plane, seen from where the edges go round to the left
 * \param[in] unit of the lattice [m]
 * \param[in] points on the plane, which give their spacing
 * \param[in] min_area of a part beside the largest, and of a hole [m^2] */
std::vector<PlanarRings>
outlineOf (const std::vector<OutlineEdge>& edges,
           const PlaneFrame& frame,
           double unit,
           double points,
           double min_area);

} // namespace pcl_ops::apps
