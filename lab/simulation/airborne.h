// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "relief.h"
#include "survey.h"

#include <optional>

namespace pcl_ops::simulation {

/** Standard deviation of the heights of points of an airborne survey [m]. */
constexpr double airborne_sigma = 0.05;

/** Points of a side of a roof with fewer points get label 0. */
constexpr std::size_t min_points_of_roof = 20;

/** A square of lots on hilly or flat ground, which is seen from above, so that walls
 * have no points. Its corner is the origin; z is up. */
struct AirborneSite {
  Relief relief = {};
  int lots = 4;         // number along each side
  double density = 0.6; // [points / m^2]
  /** The house on each lot, row by row; no value if trees cover the lot. */
  std::vector<std::optional<House>> houses = {};

  /** Returns the edge of the site [m]. */
  double
  width () const;
};

/** Makes a site about 100 m to 1 km wide, flat or with hills of 1 to 8 m amplitude. It
 * has 0.4 to 4 points per square meter, but at most 600,000 points. */
AirborneSite
makeAirborne (Seed seed);

/** Scans the site from above with equal density, in random order. Sides of roofs and
 * flat ground are planes, leaves have label 0, points on hilly ground are ignored.
 * \param[in] noise factor on \ref airborne_sigma */
SimulatedCloud
scanAirborne (const AirborneSite& site, std::size_t points, double noise, Seed seed);

} // namespace pcl_ops::simulation
