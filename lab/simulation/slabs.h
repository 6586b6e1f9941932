// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "simulated_cloud.h"

namespace pcl_ops::simulation {

/** Standard deviation of the points of slabs along the normal [m]. */
constexpr double slabs_sigma = 0.002;

/** A floor and a wall, and beside them a thin wall and a board of 4 to 15 cm that are
 * seen from both sides, but not at their edges. Both sides of the thin wall are the
 * surfaces 1 and 2, of the board 3 and 4. The sensor is the origin; z is up. */
Scene
makeSlabs (Seed seed);

/** How many are usual: 10 to 300 thousand. */
double
drawPointsOfSlabs (Seed seed);

/** All surfaces evenly. */
SimulatedCloud
scanSlabs (const Scene& scene, std::size_t points, double noise, Seed seed);

} // namespace pcl_ops::simulation
