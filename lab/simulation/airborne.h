// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "relief.h"
#include "scenes.h"

namespace pcl_ops::simulation {

/** Standard deviation of the heights of an airborne survey [m]. */
constexpr double airborne_sigma = 0.05;

/** A roof's side with fewer has label 0. */
constexpr std::size_t min_points_of_roof = 20;

/** A square of lots on hilly or flat ground, seen from above, so that walls have no
 * points. Its corner is the origin; z is up. */
struct Airborne {
  Relief relief = {};
  int lots = 4;         // along each side
  double density = 0.6; // [points / m^2]
  /** That of each lot, row by row; none: it is a wood. */
  std::vector<std::optional<House>> houses = {};

  double
  width () const;
};

/** 100 m to 1 km wide, flat or of hills up to 8 m, with .4 to 4 points on a square
 * meter, but at most 600,000. */
Airborne
makeAirborne (Seed seed);

/** Evenly from above, in no order. Sides of roofs are planes, and so is flat ground;
 * hilly ground is ignored. */
SimulatedCloud
scanAirborne (const Airborne& site, std::size_t points, double noise, Seed seed);

} // namespace pcl_ops::simulation
