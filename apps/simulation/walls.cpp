// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "walls.h"

namespace pcl_ops::simulation {

void
addWallAround (Body& body, const Rectangle& wall, const WallRange& hole, double depth)
{
  const double left = wall.center.x() - wall.half_u;
  const double right = wall.center.x() + wall.half_u;
  const double bottom = wall.center.z() - wall.half_v;
  const double top = wall.center.z() + wall.half_v;
  const SurfaceId surface = ++body.surface_count;
  for (const WallRange& range :
       {WallRange{left, hole.left, bottom, top},
        WallRange{hole.right, right, bottom, top},
        WallRange{hole.left, hole.right, hole.top, top},
        WallRange{hole.left, hole.right, bottom, hole.bottom}}) {
    Rectangle piece = range.at (0.0);
    piece.surface = surface;
    if (piece.area() > 0.0)
      body.rectangles.push_back (piece);
  }
  const Rectangle back = hole.at (-depth);
  addSurface (body, back);
  const double half_depth = 0.5 * depth;
  for (const double x : {hole.left, hole.right})
    addSurface (body,
                rectangleAlong (
                    1, 2, {x, -half_depth, back.center.z()}, half_depth, back.half_v));
  for (const double z : {hole.bottom, hole.top})
    addSurface (body,
                rectangleAlong (
                    0, 1, {back.center.x(), -half_depth, z}, back.half_u, half_depth));
}

} // namespace pcl_ops::simulation
