// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "simulated_cloud.h"

namespace pcl_ops::simulation {

/** Standard deviation of the points of plaster along the normal [m]. */
constexpr double plaster_sigma = 0.001;

/** The laser scan of an empty room whose six sides are wavy. */
struct Plaster {
  double amplitude = 0.008; // of waves 3 m long, across 4.2 m [m]
  std::size_t points = 20'000;
};

/** With waves of 2 to 15 mm. The seeds 1 to 7 have 20 thousand to 2 million points, and
 * so all later ones. */
Plaster
drawPlaster (Seed seed);

/** The sensor is the origin; z is up. */
SimulatedCloud
scanPlaster (const Plaster& plaster, double noise, Seed seed);

} // namespace pcl_ops::simulation
