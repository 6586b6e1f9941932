// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sensors.h"

namespace pcl_ops::simulation {

/** Standard deviation of the depths of a table at its distance [m]. */
constexpr double table_sigma = 0.0006;

/** A flat table that fills the view of a depth camera whose depth errs smoothly. */
struct Table {
  double distance = 0.8;       // along the camera's axis [m]
  double tilt = 0.25 * pi;     // of the normal against the camera's axis [rad]
  double bend = 0.004;         // about the smooth error at the image's corners [m]
  double quantization = 357.0; // as in \ref CameraNoise [m]

  /** In the camera's axes. */
  Shape
  top () const;
};

/** 0.8 to 1.2 m away, bent by 1 to 6 mm. */
Table
drawTableView (Seed seed);

/** In the camera's axes: x right, y down, z forward. */
SimulatedCloud
scanTable (const Table& table,
           const DepthCamera& camera,
           double noise,
           Seed seed,
           bool organized);

} // namespace pcl_ops::simulation
