// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "geometry/points.h"
#include "voxels/voxel_grid.h"

#include <cstdint>
#include <vector>

namespace pcl_ops::internal {

/** \brief Finds the points within one radius, known beforehand, of any of the points:
 * they are sorted into voxels of that size, or larger ones where the points lie so far
 * apart that most would be nearly empty. That takes a fraction of the time a kd-tree
 * takes to build. */
class FixedRadiusSearch {
public:
  /** \param[in] points the points; not needed afterwards
   * \param[in] radius largest distance of a neighbour, above 0 [m]
   * \param[in] threads number of threads; 0: all. The result does not depend on it */
  FixedRadiusSearch (const Coordinates& points, double radius, unsigned threads);

  /** \brief The points voxel by voxel: what positions stand for below. */
  const Coordinates&
  points () const
  {
    return points_;
  }

  /** \brief Finds the points at most the radius away, the point itself included.
   * \param[in] point position of the centre in \ref points
   * \param[out] neighbours their positions in \ref points, in an order that depends on
   * the points alone; what it held is replaced
   * \return how many points it looked at for that */
  std::size_t
  find (std::uint32_t point, Indices& neighbours) const;

private:
  float squared_radius_;
  VoxelNeighbours neighbours_of_voxel_;
  /** \brief Position of each voxel's first point, and where the last voxel ends. */
  std::vector<std::uint32_t> voxel_begin_;
  Coordinates points_;
};

} // namespace pcl_ops::internal
