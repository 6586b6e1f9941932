// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sensors.h"

namespace pcl_ops::simulation {

/** Standard deviation of the depth noise at the distance of the table [m]. */
constexpr double table_sigma = 0.0006;

/** A flat table that fills the view of a depth camera. Its depths have a smooth error,
 * so that the table seems bent. */
struct Table {
  double distance = 0.8;       // along the camera's axis [m]
  double tilt = 0.25 * pi;     // angle from the camera's axis to the normal [rad]
  double bend = 0.004;         // smooth depth error, about that of the corners [m]
  double quantization = 357.0; // steps of 7 cm at 5 m, see CameraNoise::quantization

  /** Returns the top of the table in the camera's frame, wider than the view. */
  Shape
  top () const;
};

/** Draws a table 0.8 to 1.2 m away with a bend of 1 to 6 mm. */
Table
drawTableView (Seed seed);

/** Scans the table. The points are in the camera's frame: x right, y down, z forward.
 * \param[in] noise factor on the noise and on the bend; 0 also leaves out the steps of
 * depth
 * \param[in] organized see \ref toSurfaceCloud */
SimulatedCloud
scanTable (const Table& table,
           const DepthCamera& camera,
           double noise,
           Seed seed,
           bool organized);

} // namespace pcl_ops::simulation
