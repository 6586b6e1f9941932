// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "bounded/bounded_planes.h"

#include <vector>

namespace pcl_ops::internal {

/** \brief The part of a cloud that planes are looked for in, in voxels of one size: all
 * of it, or what no plane explains in voxels of twice the edge. */
struct Refinement {
  VoxelGrid grid;
  /** \brief The voxels of the refinement before that hold these. */
  Indices voxels_above;
  /** \brief Whether a voxel's points are looked at in the next refinement; empty: none.
   */
  std::vector<char> is_refined;
  /** \brief All planes so far with the voxels here that they explain. */
  BoundedPlanes planes;
};

/** \brief Takes voxels without a plane, and those next to them, to voxels of half the
 * edge. A voxel there keeps the plane of the one that holds it if its points lie on it.
 * \param[in] finer the grid of all points with half the edge
 * \param[in] voxels_above for each of its voxels the one of twice the edge that holds it
 * \param[in] threads number of threads; 0: all. The result does not depend on it
 * \param[in,out] coarse with planes and their noise; what is refined is marked */
Refinement
refine (const VoxelGrid& finer,
        const Indices& voxels_above,
        unsigned threads,
        Refinement& coarse);

/** \brief Voxels that have no plane yet, by themselves. */
struct OpenVoxels {
  /** \brief Their numbers where they come from. */
  Indices numbers;
  /** \brief They and larger ones, all connected. */
  VoxelPyramid voxels;
};

/** \brief Takes them out of a part: what a plane explains tells nothing of another.
 * \param[in] part what it is of, with planes
 * \param[in] sizes of voxels, each of twice the edge of the one before, 1 or more
 * \param[in] threads number of threads; 0: all. The result does not depend on it */
OpenVoxels
openVoxels (const Refinement& part, int sizes, unsigned threads);

/** \brief Adds planes that were found in open voxels.
 * \param[in] numbers of the open voxels
 * \param[in] found planes, of open voxels
 * \param[in,out] planes those found before; the noise of all has to be measured anew */
void
addPlanes (const Indices& numbers, const BoundedPlanes& found, BoundedPlanes& planes);

} // namespace pcl_ops::internal
