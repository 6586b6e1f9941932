// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sensors.h"

#include <functional>
#include <optional>

namespace pcl_ops::simulation {

struct Simulation {
  std::string scene = "room";
  Seed seed = 1;
  DepthCamera camera = {}; // of rooms, corners with furniture and walks
  bool has_raw_depth = false;
  std::string sensor = "lidar-64"; // of streets and drives
  double noise = 1.0;
  /** Of scans from everywhere; none: as many as usual, and rooms are seen by the
   * camera. */
  std::optional<double> points = std::nullopt;
  bool organized = false;

  bool
  hasLidar () const
  {
    return scene == "street" || scene == "drive";
  }
};

/** A cloud of any scene but a walk, a drive and a town. */
SimulatedCloud
simulate (const Simulation& simulation);

struct SensorView {
  Scene scene;
  Poses poses;
  std::function<Scan (std::size_t frame)> scan; // at each of the poses
};

/** Of a camera in a room or on a walk, of a lidar in a street or on a drive. */
SensorView
viewOf (const Simulation& simulation, std::size_t frames = 1);

/** As root mean square: a turn of so many degrees and a shift of so many
 * centimeters. */
struct PoseErrors {
  /** Of each pose by itself, and of each step between two: these add up. */
  double each = 0.0, drift = 0.0;
};

/** Poses as a measurement would have them. */
Poses
measured (const Poses& poses, const PoseErrors& errors, Seed seed);

} // namespace pcl_ops::simulation
