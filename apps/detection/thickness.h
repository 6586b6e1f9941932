// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <io/shifted_cloud.h>
#include <pcl_ops/plane.h>

#include <limits>
#include <vector>

namespace pcl_ops::apps {

/** \brief The rms distance of the inliers to their plane, to be compared with the noise
 * of small neighborhoods of the same inliers. */
struct Thickness {
  /** \brief Rms distance to the fitted plane [m]; NaN if the points span no plane. */
  double rms = std::numeric_limits<double>::quiet_NaN();
  /** \brief Median noise of the neighborhoods of some inliers [m]. A plane is fitted to
   * each neighborhood of n points; its noise is their rms distance to that plane, with
   * n - 3 degrees of freedom. It is at least a tenth of the spacing, because the rms is
   * 0 for exact points and for quantized depth. */
  double noise = rms;
  /** \brief Median spacing of the same neighborhoods: the distance between neighbors on
   * a square grid of equal density [m]. */
  double spacing = rms;

  /** \brief How many times thicker the plane is than the noise. */
  double
  factor () const
  {
    return rms / noise;
  }
};

/** \brief A plane is thick if its Thickness::factor is larger than this. The factor of
 * true planes of rooms is up to 4.0, that of real walls, tables and roofs up to 2.5:
 * the noise that neighbors share grows with the distance. Hills, and parts of different
 * planes taken for one plane, have factors of 5 to 20. */
constexpr double thick_factor = 5.0;

/** \brief Returns the thickness of each plane. A neighborhood has the 80 nearest points
 * of the whole cloud, whether they are on the plane or not. For a plane of fewer than
 * 320 inliers it has a quarter of their number, but at least 20. The size is doubled,
 * up to 16 times the first one, while the points are nearly on a line, like those of
 * one beam of a lidar. The result does not depend on the order of the points.
 * \param[in] planes with inliers and their moments
 * \param[in] probes number of inliers of each plane that get a neighborhood */
std::vector<Thickness>
thicknessOf (const XyzCloud& cloud,
             const std::vector<PlaneSegment>& planes,
             std::size_t probes = 30);

} // namespace pcl_ops::apps
