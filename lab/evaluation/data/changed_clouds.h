// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <metrics/metrics.h>

#include <array>

namespace pcl_ops::evaluation {

/** A cloud of which nothing has changed that planes depend on. */
struct ChangedCloud {
  XyzCloud::Ptr cloud;
  Vector3d up;         // against gravity, of length 1
  pcl::Indices points; // of each point, where it was in the cloud as it was
};

/** A way to change a cloud, always the same one of the same cloud. */
struct CloudChange {
  /** Of its column in results.csv, agreement_NAME. */
  const char* name;
  /** \param[in,out] changed a copy of the cloud with all its points */
  void (*apply) (ChangedCloud& changed);
};

/**  - moved: by 5 cm and more along each axis, or nearly
 * - turned: by 30 degrees about z, with the up axis and the sensor
 * - thinned: without one point in a hundred, rounded up
 * - jittered: each coordinate by up to 0.1 mm to either side
 * - rounded: coordinates are whole millimeters */
extern const std::array<CloudChange, 5> cloud_changes;

/** Exactly \p count of \p all points, ascending, each with the same chance (Knuth, The
 * Art of Computer Programming 2, algorithm S); always the same ones. */
pcl::Indices
drawPoints (std::size_t all, std::size_t count);

ChangedCloud
changedCloud (const XyzCloud& cloud, const Vector3d& up, const CloudChange& change);

} // namespace pcl_ops::evaluation
