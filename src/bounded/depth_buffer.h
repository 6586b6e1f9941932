// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "voxels/voxel_grid.h"

#include <vector>

namespace pcl_ops::internal {

/** \brief What can be seen from a viewpoint in a direction. */
enum class Sight {
  /** \brief No voxel lies that way. */
  Nothing,
  /** \brief A voxel in front of the place looked at hides it. */
  Hidden,
  /** \brief A voxel at the place. */
  There,
  /** \brief Only voxels behind the place: it was looked at and found empty. */
  Through
};

/** \brief The nearest and farthest voxels in each direction from a viewpoint: a coarse
 * depth image on the six faces of a cube. */
class DepthBuffer {
public:
  DepthBuffer (const VoxelGrid& grid, const Eigen::Vector3d& viewpoint);

  /** \brief What is seen when looking at a place.
   * \param[in] margin distances differing by less count as equal [m] */
  Sight
  lookAt (const Eigen::Vector3d& place, double margin) const;

private:
  struct Range {
    float nearest, farthest;
  };

  void
  draw (const Eigen::Vector3d& offset, double half_width);

  Eigen::Vector3d viewpoint_;
  std::vector<Range> ranges_;
};

} // namespace pcl_ops::internal
