// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

namespace pcl_ops {

/** \brief Wall time of each stage of the last call [ms]. */
struct StageDurations {
  double search = 0.0;
  double normals = 0.0;
  double extraction = 0.0;
  double assignment = 0.0;
  double merging = 0.0;
  /** \brief Everything between a loaded cloud and labels for all points. */
  double detection = 0.0;
};

/** \brief Lengths that a detection worked with, whether they were given or followed the
 * cloud [m]. */
struct UsedLengths {
  /** \brief Edge of the voxels, as parameters have it; of voxels of several sizes, of
   * the smallest that planes begin in. None: the detector has no voxels. */
  std::optional<double> voxel_size;
  /** \brief Farthest a point may be from its plane; where this follows the noise of
   * each plane, the median over the planes. None: no plane was found to tell it. */
  std::optional<double> distance_threshold;
};

} // namespace pcl_ops
