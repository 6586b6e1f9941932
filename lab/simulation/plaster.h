// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "simulated_cloud.h"

namespace pcl_ops::simulation {

/** Standard deviation of the points along the normal of a wavy side [m]. */
constexpr double plaster_sigma = 0.001;

/** The laser scan of an empty room whose six sides are wavy. */
struct Plaster {
  double amplitude = 0.008;    // of waves of 3 m by 4.2 m [m]
  std::size_t points = 20'000; // number of points of the scan
};

/** Draws an amplitude of 2 to 15 mm. The seeds 1 to 7 have 20 thousand to 2 million
 * points; later seeds repeat these numbers. */
Plaster
drawPlaster (Seed seed);

/** Scans the room. The sensor is at the origin; z is up.
 * \param[in] noise_factor multiplies the noise and the amplitude */
SimulatedCloud
scanPlaster (const Plaster& plaster, double noise_factor, Seed seed);

} // namespace pcl_ops::simulation
