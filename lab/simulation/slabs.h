// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "simulated_cloud.h"

namespace pcl_ops::simulation {

/** Standard deviation of the points of slabs along the normal [m]. */
constexpr double slabs_sigma = 0.002;

/** A thin wall and a board, 4 to 15 cm thick, with points on both sides, but none on
 * their edges; a floor and a second wall, with points on one side. The two sides of the
 * thin wall are the surfaces 1 and 2, those of the board 3 and 4. The sensor is at the
 * origin; z is up. */
Scene
makeSlabs (Seed seed);

/** Draws the number of points of a cloud: 10,000 to 300,000, with a uniform logarithm.
 */
double
drawPointCountOfSlabs (Seed seed);

/** Draws points that are evenly spread over all surfaces.
 * \param[in] noise factor on \ref slabs_sigma */
SimulatedCloud
scanSlabs (const Scene& scene, std::size_t points, double noise, Seed seed);

} // namespace pcl_ops::simulation
