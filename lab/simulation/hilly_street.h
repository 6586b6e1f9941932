// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "relief.h"
#include "sensors.h"

namespace pcl_ops::simulation {

/** Leaves that a ray meets anywhere on its way through a ball, or passes between. */
struct Bush {
  Vector3d center = Vector3d::Zero();
  double radius = 1.0; // [m]
};

/** A street along x between walls and bushes, on hills. The origin is a lidar 2 m above
 * the ground; z is up. */
struct HillyStreet {
  Relief relief = {};
  Scene walls = {};
  std::vector<Bush> bushes = {};
  Lidar lidar = lidarOf ("lidar-64-level");

  /** [m] */
  double
  ground (double x, double y) const;
};

/** With 370 to 1,800 directions of the lidar. */
HillyStreet
makeHillyStreet (Seed seed);

/** Walls are planes, bushes are on none, the ground is ignored. */
SimulatedCloud
scanHillyStreet (const HillyStreet& street, double noise, Seed seed, bool organized);

} // namespace pcl_ops::simulation
