// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <io/shifted_cloud.h>
#include <pcl_ops/plane.h>

#include <limits>
#include <vector>

namespace pcl_ops::apps {

/** \brief How far the inliers of a plane are from it, and the noise of small
 * neighborhoods of the same inliers for comparison. Members are NaN where points span
 * no plane. */
struct Thickness {
  /** \brief Rms distance of all inliers to the plane that is fitted to them [m]. */
  double rms = std::numeric_limits<double>::quiet_NaN();
  /** \brief Median noise of the neighborhoods of some inliers [m]. The noise of a
   * neighborhood of n points is their rms distance to the plane that is fitted to them,
   * with n - 3 degrees of freedom. But it is at least a tenth of the spacing of the
   * neighborhood, as the rms is 0 for exact points and for quantized depth. */
  double noise = std::numeric_limits<double>::quiet_NaN();
  /** \brief Median spacing of the same neighborhoods: the distance between neighbors on
   * a square grid of equal density [m]. */
  double spacing = std::numeric_limits<double>::quiet_NaN();

  /** \brief How many times thicker the plane is than the noise. */
  double
  factor () const
  {
    return rms / noise;
  }
};

/** \brief A plane is thick if its Thickness::factor is larger than this. The factor of
 * true planes of rooms is up to 4.0, that of real walls, tables and roofs up to 2.5. It
 * is above 1 where neighboring points err alike: their common error does not count as
 * noise of a small neighborhood. Hills, and parts of different planes taken for one
 * plane, have factors of 5 to 20. */
constexpr double thick_factor = 5.0;

/** \brief Returns the thickness of each plane. The neighborhood of an inlier has the 80
 * points of the whole cloud that are nearest to it, on the plane or not. For a plane
 * with fewer than 320 inliers it has a quarter of this number of points, but at
 * least 20. The number is doubled, up to 16 times the first one, while the points are
 * nearly on a line, like those of one beam of a lidar. The result does not depend on
 * the order of the points.
 * \param[in] planes with inliers and their moments
 * \param[in] probes number of inliers of each plane that get a neighborhood */
std::vector<Thickness>
thicknessOf (const XyzCloud& cloud,
             const std::vector<PlaneSegment>& planes,
             std::size_t probes = 30);

} // namespace pcl_ops::apps
