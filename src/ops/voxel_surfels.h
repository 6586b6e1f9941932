// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bounded/refinement.h"
#include "detection/labelled_planes.h"
#include "ops/surfels.h"
#include "voxels/voxel_grid.h"
#include <pcl_ops/oriented_point_sampling.h>

#include <optional>
#include <vector>

namespace pcl_ops::internal {

/** \brief Planes with the voxels they are on, coarse ones and, where those were not
 * enough, finer ones. */
struct RefinedPlanes {
  BoundedPlanes coarse;
  /** \brief With all planes. */
  Refinement finer;
  /** \brief How many planes were found, those since joined counted one by one. */
  std::size_t found = 0;

  std::size_t
  size () const
  {
    return found;
  }
};

/** \brief Edge of the largest voxels where their size is given; else 0. Voxels of a
 * given size begin at whole multiples of it in the frame of the input cloud, so that
 * parts of a cloud have the voxels of the whole. */
double
coarsestVoxel (const SurfelParameters& surfels);

/** \brief Real walls are not flat: whether two planes are one follows their noise. */
MergingParameters
mergingByNoise (MergingParameters merging);

/** \brief The recommended sampling: the flat voxels of a grid, with the normals of the
 * moments around; planes end where their voxels end. Coarse first: only points that no
 * plane explains are looked at more closely. */
class VoxelSurfels {
public:
  /** \param[in] parameters used as long as this is */
  explicit VoxelSurfels (const OrientedPointSamplingParameters& parameters)
  : parameters_ (parameters)
  {}

  /** \return an empty grid where the points span no voxels */
  VoxelizedPoints
  sample (const Points& points) const;

  std::vector<std::optional<Surfel>>
  orient (const Points& points, const VoxelizedPoints& voxelized) const;

  /** \brief Planes in coarse voxels first, then in finer ones of the points left. */
  RefinedPlanes
  extract (const Points& points,
           const VoxelizedPoints& voxelized,
           const std::vector<std::optional<Surfel>>& surfels) const;

  /** \brief Which voxels are whose in the end, and how much noise there is. */
  void
  bound (const Points& points,
         const VoxelizedPoints& voxelized,
         RefinedPlanes& planes) const;

  AssignedPoints
  assign (const Points& points,
          const VoxelizedPoints& voxelized,
          const RefinedPlanes& planes) const;

  /** \brief Fits the planes to their points; their bounds have been settled. */
  LabelledPlanes
  merge (AssignedPoints assigned) const;

private:
  /** \brief Labels the points of the voxels' planes. */
  AssignedPoints
  assignInVoxels (const Points& points,
                  const VoxelizedPoints& voxelized,
                  const RefinedPlanes& planes) const;

  /** \brief Looks for planes among points too sparse for the voxels of the others. */
  void
  addSparse (const Points& points,
             const VoxelizedPoints& voxelized,
             AssignedPoints& assigned) const;

  const OrientedPointSamplingParameters& parameters_;
};

} // namespace pcl_ops::internal
