// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "grid_scene.h"
#include "voxels/bounded_planes.h"

// The ground and the wall pass through the middles of 20 x 20 voxels of 10 cm each. A
// grid of grid_steps x grid_steps points on them has 6 x 6 points in each voxel.
constexpr std::size_t voxels_of_surface = 20 * 20;
constexpr int grid_steps = 120;
constexpr std::size_t points_of_surface = grid_steps * grid_steps;
/** \brief The noise that the planes of a VoxelScene are said to have [m], whatever the
 * offsets of the points. */
constexpr double noise_of_planes = 6_mm;
inline const Surface ground = {{0, 0, 0.05}, {2, 0, 0}, {0, 2, 0}};
inline const Surface wall = {{0.05, 0, 0}, {0, 2, 0}, {0, 0, 2}};

/** \brief Number of voxels with this plane index, which may be no_plane. */
inline std::size_t
countVoxelsOn (std::int32_t plane, const pcl_ops::internal::BoundedPlanes& planes)
{
  return static_cast<std::size_t> (
      std::count (planes.plane_of_voxel.begin(), planes.plane_of_voxel.end(), plane));
}

/** \brief Points in voxels of 10 cm. Each voxel has the plane of its first point. */
struct VoxelScene {
  /** \param[in] surfaces one list of surfaces for each plane; the plane goes through
   * the first surface of its list; each surface has a grid of grid_steps x grid_steps
   * points
   * \param[in] max_offset of points along the normal, as in \ref addGrid [m] */
  explicit VoxelScene (const std::vector<std::vector<Surface>>& surfaces,
                       double max_offset = 0.0)
  {
    std::vector<std::int32_t> plane_of_point;
    for (const std::vector<Surface>& plane : surfaces) {
      for (const Surface& surface : plane)
        addGrid (points, surface, grid_steps, max_offset);
      plane_of_point.resize (points.size(), static_cast<std::int32_t> (planes.size()));
      addPlane (pcl_ops::planeThrough (plane[0].center(), plane[0].normal()));
    }
    voxelize();
    const pcl_ops::internal::Indices voxels = voxelsOfPoints (grid());
    for (std::size_t i = points.size(); i-- > 0;) // the first point of a voxel wins
      planes.plane_of_voxel[voxels[i]] = plane_of_point[i];
  }

  /** \brief Sorts all points into voxels, e.g. after points were added, and puts all
   * voxels on plane 0. */
  void
  voxelize ()
  {
    voxelized = connectedVoxels (points, 10_cm);
    planes.plane_of_voxel.assign (grid().size(), 0);
  }

  /** \brief Adds a plane with \ref noise_of_planes; no voxel is on it yet. */
  void
  addPlane (const pcl_ops::Plane& plane)
  {
    planes.planes.push_back (plane);
    planes.noise.push_back (noise_of_planes);
  }

  /** \brief The voxels of 10 cm. */
  const pcl_ops::internal::VoxelGrid&
  grid () const
  {
    return voxelized.coarse;
  }

  /** \brief The centroid of the points of a voxel. */
  Eigen::Vector3d
  centroid (std::size_t voxel) const
  {
    return grid().moments[voxel].centroid();
  }

  /** \brief Puts the voxels whose centroid is selected on a plane, or on no_plane. */
  template <typename IsSelected>
  void
  label (std::int32_t plane, IsSelected&& isSelected)
  {
    for (std::size_t voxel = 0; voxel < grid().size(); ++voxel)
      if (isSelected (centroid (voxel)))
        planes.plane_of_voxel[voxel] = plane;
  }

  pcl_ops::internal::Coordinates points;
  pcl_ops::internal::VoxelLevels voxelized;
  pcl_ops::internal::BoundedPlanes planes;
};
