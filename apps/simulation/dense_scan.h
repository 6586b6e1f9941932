// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "simulated_cloud.h"

namespace pcl_ops::simulation {

/** \brief Standard deviation of a terrestrial laser scanner's distances [m]. */
constexpr double laser_sigma = 0.003;

/** \brief Scans all surfaces of a scene evenly, whatever hides them: a registered scan
 * from everywhere. The points follow the surfaces one after the other. The sensor's
 * origin is the middle of the first body, the room's shell.
 * \param[in] scene what is scanned
 * \param[in] points exact number of points; none if the scene is empty
 * \param[in] noise_scale factor on \ref laser_sigma, the noise along the normal
 * \param[in] seed the same seed gives the same cloud */
SimulatedCloud
scanDensely (const Scene& scene,
             std::size_t points,
             double noise_scale,
             std::uint32_t seed);

} // namespace pcl_ops::simulation
