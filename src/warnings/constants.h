// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstddef>

namespace pcl_ops::internal {

/** \brief From what on results are doubtful. Each limit is beyond what ordinary clouds
 * reach, as a warning that is often wrong is no longer read. */
struct WarningConstants {
  // Planes thicker than their surroundings.
  /** \brief An rms of so many noises: what bends or steps within the plane is more than
   * what scatters about it. */
  double thick_noises = 3.0;
  /** \brief Less than this share of the spacing of its points does not show: the road
   * below a lidar of 16 beams bends by a centimeter where points are a decimeter apart.
   */
  double min_rms_of_spacing = 0.125;
  /** \brief Share of the points on planes from which on the result as a whole is thick.
   * Single roads that bend are up to 0.49 of a lidar scan. */
  double thick_share = 0.5;
};

inline constexpr WarningConstants warning_constants;

} // namespace pcl_ops::internal
