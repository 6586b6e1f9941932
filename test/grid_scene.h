// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud/points.h"
#include "cloud/voxel_grid.h"
#include "scene.h"

/** \brief So many points, drawn uniformly in a cube that is centered at the origin.
 * \param[in] edge of the cube [m] */
inline pcl_ops::internal::Coordinates
pointsInACube (std::size_t number, double edge)
{
  RandomGenerator generator (seedOfTest());
  const auto draw = [&] {
    return static_cast<float> (edge * (drawUnit (generator) - 0.5));
  };
  pcl_ops::internal::Coordinates points;
  for (std::size_t i = 0; i < number; ++i) {
    const float x = draw(), y = draw(), z = draw();
    points.add (x, y, z);
  }
  return points;
}

/** \brief Adds a grid of steps x steps points on a surface, none of them on its rim.
 * \param[in] max_offset each point is moved along the normal by a distance drawn
 * uniformly from -max_offset to max_offset [m] */
inline void
addGrid (pcl_ops::internal::Coordinates& points,
         const Surface& surface,
         int steps,
         double max_offset = 0.0)
{
  RandomGenerator generator (seedOfTest());
  for (int i = 0; i < steps; ++i)
    for (int j = 0; j < steps; ++j) {
      const double offset = max_offset * (2.0 * drawUnit (generator) - 1.0);
      const pcl::PointXYZ point =
          toPoint (surface.at ((i + 0.5) / steps, (j + 0.5) / steps) +
                   offset * surface.normal());
      points.add (point.x, point.y, point.z);
    }
}

/** \brief The points of \ref addGrid on each of several surfaces, one surface after
 * the other. All surfaces get the same offsets. */
inline pcl_ops::internal::Points
gridsOf (const std::vector<Surface>& surfaces, int steps, double max_offset = 0.0)
{
  pcl_ops::internal::Points points;
  for (const Surface& surface : surfaces)
    addGrid (points, surface, steps, max_offset);
  return points;
}

/** \brief Sorts points into coarse voxels with an edge of \p voxel_size [m] and into
 * fine voxels with half that edge. The coarse voxels know their neighbors. */
inline pcl_ops::internal::VoxelLevels
connectedVoxels (const pcl_ops::internal::Coordinates& points, double voxel_size)
{
  pcl_ops::internal::VoxelLevels voxels =
      coarsen (voxelize (points, 0.5 * voxel_size, one_thread));
  connect (voxels.coarse, one_thread);
  return voxels;
}

/** \brief The coarse voxels of \ref connectedVoxels. */
inline pcl_ops::internal::VoxelGrid
connectedGrid (const pcl_ops::internal::Coordinates& points, double voxel_size)
{
  return connectedVoxels (points, voxel_size).coarse;
}
