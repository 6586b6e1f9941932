// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene.h"

namespace pcl_ops::simulation {

/** \brief A straight street; z is up, z = 0 the road, the origin its middle. Its
 * direction is turned by \ref yaw against the x axis. */
struct Street {
  Scene scene;
  double length = 0.0, width = 0.0; // width of the road between the curbs [m]
  double yaw = 0.0;                 // [rad]
};

/** \brief Draws a road between curbs and sloping sidewalks, with houses, parked cars,
 * trees, bushes and poles on both sides. */
Street
makeStreet (Seed seed);

/** \brief Draws where a car in the right lane near the middle carries a sensor, in its
 * axes x forward, y left, z up: 1.7 to 1.9 m above the road, tilted by up to a degree.
 */
Isometry3d
drawSensorPose (const Street& street, Seed seed);

/** \brief Draws a drive along the right lane through the middle of a street, in equal
 * steps of up to 1 m and over at most half of it; the car sways a little. */
Poses
drawDrive (const Street& street, std::size_t frames, Seed seed);

} // namespace pcl_ops::simulation
