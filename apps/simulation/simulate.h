// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "depth_camera.h"

#include <functional>
#include <optional>
#include <string>

namespace pcl_ops::simulation {

/** \brief What is simulated: a scene of which name and how it is seen. */
struct Simulation {
  std::string scene = "room";
  std::uint32_t seed = 1;
  /** \brief Of rooms, corners with furniture and walks. */
  DepthCamera camera = {};
  bool has_raw_depth = false;
  /** \brief Of streets and drives. */
  std::string sensor = "lidar-64";
  double noise = 1.0;
  /** \brief Of scans from everywhere; none: as many as such a scene usually has, and
   * rooms are seen by the camera. */
  std::optional<double> points = std::nullopt;
  bool organized = false;
};

/** \brief A cloud of any scene but a walk, a drive and a town. */
SimulatedCloud
simulate (const Simulation& simulation);

/** \brief What a camera sees on a walk through a room, or a lidar on a drive. */
struct WayView {
  std::vector<Eigen::Isometry3d> poses;
  /** \brief In the frame of the sensor, labeled by the surfaces of the scene. */
  std::function<LabeledCloud (std::size_t frame)> look;
};

WayView
simulateWay (const Simulation& simulation, std::size_t frames);

} // namespace pcl_ops::simulation
