// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ops/voxel_surfels.h"
#include "voxel_scene.h"

/** \brief 14400 points of each surface, moved along its normal by up to a noise [m]. */
inline pcl_ops::internal::Points
pointsOf (const std::vector<Surface>& surfaces, double noise = 0.0)
{
  pcl_ops::internal::Points points;
  for (const Surface& surface : surfaces)
    addGrid (points, surface, 120, noise);
  return points;
}

/** \brief Points, and the stages of OPS on their surfels, with voxels of 10 cm. */
struct SurfelScene {
  explicit SurfelScene (pcl_ops::internal::Points some_points)
  : points (std::move (some_points))
  {
    parameters.surfels.voxel_size = 10_cm;
  }

  pcl_ops::internal::VoxelizedPoints
  sample () const
  {
    return policy.sample (points);
  }

  pcl_ops::internal::RefinedPlanes
  extract () const
  {
    const pcl_ops::internal::VoxelizedPoints voxelized = sample();
    return policy.extract (points, voxelized, policy.orient (points, voxelized));
  }

  /** \brief Of a scene all of whose voxels are finer ones. */
  pcl_ops::internal::RefinedPlanes
  boundAll (const VoxelScene& scene) const
  {
    pcl_ops::internal::RefinedPlanes planes;
    planes.finer.voxelized = scene.voxelized;
    planes.finer.planes = scene.planes;
    for (std::size_t p = 0; p < scene.planes.size(); ++p) {
      planes.finer.planes.became.push_back (static_cast<std::int32_t> (p));
      planes.coarse.plane_of_voxel.push_back (static_cast<std::int32_t> (p));
    }
    policy.bound (points, scene.voxelized, planes);
    return planes;
  }

  pcl_ops::internal::BoundedPlanes
  bound (const VoxelScene& scene) const
  {
    return boundAll (scene).finer.planes;
  }

  pcl_ops::internal::Points points;
  pcl_ops::OrientedPointSamplingParameters parameters;
  pcl_ops::internal::VoxelSurfels policy{parameters};
};

inline std::size_t
voxelsOn (std::int32_t plane, const pcl_ops::internal::BoundedPlanes& planes)
{
  return static_cast<std::size_t> (
      std::count (planes.plane_of_voxel.begin(), planes.plane_of_voxel.end(), plane));
}
