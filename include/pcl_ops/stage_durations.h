// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

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

} // namespace pcl_ops
