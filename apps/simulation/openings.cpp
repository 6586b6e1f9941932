// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "openings.h"

namespace pcl_ops::simulation {

using Eigen::Vector3d;

Rectangle
upright (double left, double right, double bottom, double top, double y)
{
  return {{0.5 * (left + right), y, 0.5 * (bottom + top)},
          Vector3d::UnitX(),
          Vector3d::UnitZ(),
          0.5 * (right - left),
          0.5 * (top - bottom)};
}

void
addWallAround (Body& body, const Opening& hole, const Rectangle& wall)
{
  const double left = wall.center.x() - wall.half_u;
  const double right = wall.center.x() + wall.half_u;
  const double bottom = wall.center.z() - wall.half_v;
  const double top = wall.center.z() + wall.half_v;
  const SurfaceId surface = ++body.surface_count;
  for (Rectangle piece : {upright (left, hole.left, bottom, top, 0.0),
                          upright (hole.right, right, bottom, top, 0.0),
                          upright (hole.left, hole.right, hole.top, top, 0.0),
                          upright (hole.left, hole.right, bottom, hole.bottom, 0.0)}) {
    piece.surface = surface;
    if (piece.area() > 0.0)
      body.rectangles.push_back (piece);
  }
}

void
addRecess (Body& body, const Opening& hole)
{
  addSurface (body,
              upright (hole.left, hole.right, hole.bottom, hole.top, -hole.depth));
  const double half_depth = 0.5 * hole.depth;
  const double middle_x = 0.5 * (hole.left + hole.right);
  const double middle_z = 0.5 * (hole.bottom + hole.top);
  for (const double x : {hole.left, hole.right})
    addSurface (body,
                {{x, -half_depth, middle_z},
                 Vector3d::UnitY(),
                 Vector3d::UnitZ(),
                 half_depth,
                 0.5 * (hole.top - hole.bottom)});
  for (const double z : {hole.bottom, hole.top})
    addSurface (body,
                {{middle_x, -half_depth, z},
                 Vector3d::UnitX(),
                 Vector3d::UnitY(),
                 0.5 * (hole.right - hole.left),
                 half_depth});
}

} // namespace pcl_ops::simulation
