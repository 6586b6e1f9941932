// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "relief.h"
#include "sensors.h"

namespace pcl_ops::simulation {

/** A ball of leaves. A ray hits a leaf anywhere inside the ball, or passes through. */
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

  /** Returns z of the ground in the lidar's frame [m]. */
  double
  groundHeight (double x, double y) const;
};

/** Draws a street, and the azimuth steps of its lidar in a turn: 370 to 1,800. */
HillyStreet
makeHillyStreet (Seed seed);

/** Scans the street. Walls are planes, points on bushes have label 0, those on
 * the ground have no known truth.
 * \param[in] noise factor on \ref lidar_sigma
 * \param[in] organized see \ref toSurfaceCloud */
SimulatedCloud
scanHillyStreet (const HillyStreet& street, double noise, Seed seed, bool organized);

} // namespace pcl_ops::simulation
