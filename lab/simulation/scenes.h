// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "furniture.h"
#include "sensors.h"
#include "survey.h"
#include "town.h"

#include <functional>
#include <optional>

namespace pcl_ops::simulation {

/** A room or a street; z is up, the origin the middle of the floor or the road. */
struct Site {
  Scene scene;
  /** Length, width and height of a room or, without height, a road [m]. */
  Vector3d size = Vector3d::Zero();
  /** Angle from the x axis to the length [rad]. */
  double yaw = 0.0;
};

/** Makes a room with doors, niches, furniture, tilted boards and round clutter. */
Site
makeRoom (Seed seed);

/** Makes a floor and two walls with tables, benches and racks of boards on posts:
 * narrow planes beside wide ones. */
Site
makeFurnishedCorner (Seed seed);

/** Counts the surfaces that have at least 5 of the 48 x 36 pixels of a depth camera.
 * Returns 0 if the depth of any pixel is below 0.7 m: no camera is held so near.
 * \param[in] pose of the camera */
int
countVisibleSurfaces (const Scene& scene, const Isometry3d& pose);

/** Draws a camera pose at a person's height, with little roll, looking somewhat
 * downwards, from where many surfaces are visible. */
Isometry3d
drawCameraPose (const Site& room, Seed seed);

/** Draws the poses of a camera that goes three quarters of a turn around the middle of
 * a room and looks across the middle. Each wall is out of view for a part of the way.
 * \param[in] frames number of poses */
Poses
drawWalk (const Site& room, std::size_t frames, Seed seed);

/** Makes a straight road between curbs and sloping sidewalks, with houses, parked cars,
 * trees, bushes and poles on both sides. */
Site
makeStreet (Seed seed);

/** Draws the pose of a lidar on a car, in the right lane near the middle of the street.
 * The lidar has x forward, y left and z up. */
Isometry3d
drawSensorPose (const Site& street, Seed seed);

/** Draws lidar poses along the right lane, in equal steps of up to 1 m. They cover at
 * most half of the street's length, around its middle; the car sways a little.
 * \param[in] frames number of poses */
Poses
drawDrive (const Site& street, std::size_t frames, Seed seed);

/** Standard deviation of the points of shapes along their normal [m]. */
constexpr double shapes_sigma = 0.002;

/** Scans a sphere, a cylinder, a cone and a torus in a row, parts of four larger shapes
 * of these kinds behind them, and beside them a ground with a board on it. The round
 * shapes do not touch each other. Their radii are 0.1 to 5.5 m. All surfaces get points
 * with equal density, also hidden ones; z is up.
 * \param[in] noise factor on \ref shapes_sigma */
SimulatedCloud
simulateShapes (std::size_t points, double noise, Seed seed);

/** What a cloud is simulated from. */
struct Simulation {
  std::string scene = "room"; // see --scene of pcl_ops_simulate
  Seed seed = 1;
  DepthCamera camera = {};         // for scenes that have no lidar
  bool has_raw_depth = false;      // CameraNoise::is_raw
  std::string sensor = "lidar-64"; // Lidar::name, for streets and drives
  double noise = 1.0;              // factor on the noise of the scene
  /** Number of points of scans without a sensor position. nullopt: the default of the
   * scene; a room or a corner is then seen by the camera. */
  std::optional<double> points = std::nullopt;
  bool organized = false; // see toSurfaceCloud

  /** Whether \ref sensor is used. */
  bool
  hasLidar () const
  {
    return scene == "street" || scene == "drive";
  }
};

/** Simulates one cloud of any scene except walk, drive and town. */
SimulatedCloud
simulate (const Simulation& simulation);

/** A scene, and what a sensor that moves sees of it. */
struct SensorView {
  Scene scene;
  Poses poses;                                  // of the sensor, for each frame
  std::function<Scan (std::size_t frame)> scan; // returns the scan from poses[frame]
};

/** Returns the view of a camera in a room, a corner or on a walk, or of a lidar in a
 * street or on a drive.
 * \param[in] frames number of poses of a walk or a drive; other scenes have one pose */
SensorView
viewOf (const Simulation& simulation, std::size_t frames = 1);

/** Root mean square pose errors: a value x is a rotation of x degrees and a shift of x
 * centimeters. */
struct PoseErrors {
  double each = 0.0;  // error of each pose, independent of other poses
  double drift = 0.0; // error of each step from pose to pose; the sum grows
};

/** Returns the poses with random errors, as a measurement gives them. */
Poses
measuredPoses (const Poses& poses, const PoseErrors& errors, Seed seed);

} // namespace pcl_ops::simulation
