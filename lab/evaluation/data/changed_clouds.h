// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <metrics/metrics.h>

#include <array>

namespace pcl_ops::evaluation {

/** A cloud changed in a way that should leave its planes as they are. */
struct ChangedCloud {
  XyzCloud::Ptr cloud;
  Vector3d up;         // unit vector against gravity
  pcl::Indices points; // for each point its index before the change
};

/** A way to change a cloud. The same cloud is always changed in the same way. */
struct CloudChange {
  /** The column agreement_NAME in results.csv has its results. */
  const char* name;
  /** \param[in,out] changed a copy of the cloud with all its points */
  void (*apply) (ChangedCloud& changed);
};

/** - moved: by 4 to 8 cm along each axis, the sensor, too
 * - turned: by 30 degrees about z, the sensor and the up axis, too
 * - thinned: one point in a hundred is left out, rounded up
 * - jittered: each coordinate is moved by up to 0.1 mm to either side
 * - rounded: coordinates are rounded to whole millimeters */
extern const std::array<CloudChange, 5> cloud_changes;

/** Draws \p count different ones of the indices 0 to \p all - 1, each with the same
 * chance, always the same ones (Knuth, The Art of Computer Programming 2, algorithm S).
 * \return ascending */
pcl::Indices
drawPoints (std::size_t all, std::size_t count);

/** \param[in] up against gravity, of length 1 */
ChangedCloud
changedCloud (const XyzCloud& cloud, const Vector3d& up, const CloudChange& change);

} // namespace pcl_ops::evaluation
