// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "simulated_cloud.h"

#include <functional>

namespace pcl_ops::simulation {

/** \brief A point of a surface and the direction its distance errs in. */
struct SurfacePoint {
  Eigen::Vector3d position, normal;
};

/** \brief A surface and a uniform draw of its points. */
struct ScannedSurface {
  double area;
  SurfaceId surface;
  std::function<SurfacePoint (Random&)> draw;
};

/** \brief A direction across the z axis. */
Eigen::Vector3d
drawAcross (Random& random);

/** \brief A point of a sphere above some height, in multiples of the radius. */
SurfacePoint
drawAbove (double lowest, const Eigen::Vector3d& center, double radius, Random& random);

/** \brief Of a cylinder from its side only. */
SurfacePoint
drawPoint (const Shape& shape, Random& random);

/** \brief Points spread over surfaces by area, one surface after the other, with its
 * identity as label.
 * \param[in] points exact number of points; none if the surfaces have no area
 * \param[in] sigma standard deviation along the normal [m] */
LabeledCloud
drawPoints (const std::vector<ScannedSurface>& surfaces,
            std::size_t points,
            double sigma,
            Random& random);

/** \brief Standard deviation of a terrestrial laser scanner's distances [m]. */
constexpr double laser_sigma = 0.003;

/** \brief Scans all surfaces of a scene evenly, whatever hides them: a registered scan
 * from everywhere. The sensor's origin is the middle of the first body, the room's
 * shell. */
SimulatedCloud
scanDensely (const Scene& scene,
             std::size_t points,
             double noise_scale,
             std::uint32_t seed);

} // namespace pcl_ops::simulation
