// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <metrics/metrics.h>

#include <array>

namespace pcl_ops::evaluation {

/** A cloud after a change that should not affect which planes a detector finds. */
struct ChangedCloud {
  XyzCloud::Ptr cloud;
  Vector3d up;         // unit vector against gravity, in the frame after the change
  pcl::Indices points; // index that each point had in the cloud before the change
};

/** A change of a cloud. It is deterministic: the same cloud gives the same result. */
struct CloudChange {
  /** results.csv has the agreement of the labels in the column agreement_NAME. */
  const char* name;
  /** \param[in,out] changed a copy of the cloud with all its points */
  void (*apply) (ChangedCloud& changed);
};

/** The changes by their names:
 * - moved: points and sensor origin are shifted by 4 to 8 cm along each axis
 * - turned: points, sensor origin and up axis are rotated by 30 degrees about z
 * - thinned: one point in a hundred, rounded up, is left out
 * - jittered: uniform noise of up to +-0.1 mm is added to each coordinate
 * - rounded: coordinates are rounded to whole millimeters */
extern const std::array<CloudChange, 5> cloud_changes;

/** Draws \p count different indices from 0 to \p size - 1, each with equal probability
 * (Knuth, The Art of Computer Programming 2, algorithm S). The seed is fixed, so that
 * equal arguments give equal indices.
 * \return ascending indices */
pcl::Indices
drawIndices (std::size_t size, std::size_t count);

/** Returns a changed copy of a cloud.
 * \param[in] up unit vector against gravity, in the frame of the cloud */
ChangedCloud
changedCloud (const XyzCloud& cloud, const Vector3d& up, const CloudChange& change);

} // namespace pcl_ops::evaluation
