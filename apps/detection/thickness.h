// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <io/shifted_cloud.h>
#include <pcl_ops/plane.h>

#include <limits>
#include <vector>

namespace pcl_ops::apps {

/** \brief How far the points of a plane are from it, beside how far they are from the
 * planes of their own surroundings. */
struct Thickness {
  /** \brief About the plane [m]; NaN where the points span none. */
  double rms = std::numeric_limits<double>::quiet_NaN();
  /** \brief The median over some points of the rms of their nearest neighbors about
   * the plane fitted to these, with n - 3 degrees of freedom [m]. At least a tenth of
   * the spacing, because this rms is 0 for exact points and for quantized depth. */
  double noise = rms;
  /** \brief Median distance between neighbors on a regular grid as dense as these [m].
   */
  double spacing = rms;

  double
  factor () const
  {
    return rms / noise;
  }
};

/** \brief A plane is thick above this factor. True planes of rooms reach 4.0 and real
 * walls, tables and roofs 2.5, as noise that neighbors share grows with the distance;
 * hills, and parts of different planes taken for one, have 5 to 20. */
constexpr double thick_factor = 5.0;

/** \brief By the nearest neighbors in the whole cloud, which may be on other planes or
 * on none: 80, in planes of fewer than 320 points a quarter of these, but 20 at least;
 * twice as many, up to 16 times, while they are nearly on a line, like those of one
 * beam of a lidar. Independent of the order of the points.
 * \param[in] planes with inliers and their moments
 * \param[in] probes how many points of each plane are looked at */
std::vector<Thickness>
thicknessOf (const XyzCloud& cloud,
             const std::vector<PlaneSegment>& planes,
             std::size_t probes = 30);

} // namespace pcl_ops::apps
