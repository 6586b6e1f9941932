// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sensors.h"

#include <functional>
#include <optional>

namespace pcl_ops::simulation {

/** Draws a piece of furniture that stands on z = 0 around the origin, with its back
 * towards -y. */
using DrawFurniture = Body (Random& random);

/** A desk, a cupboard, a shelf, a bed, a sofa or a leaning board. */
DrawFurniture drawAtWall;
/** A table, a chair, cartons, a panel of any tilt, or round things. */
DrawFurniture drawAnywhere;
DrawFurniture drawLeaningBoard, drawRamp;
/** A ball, a bin, a lamp or a rolled carpet: nothing planar. */
DrawFurniture drawRoundClutter;

/** Boards on four square posts, 2 to 6 cm thick. Each face is a surface, however
 * narrow. No two faces of a piece are coplanar, as a detector could rightly join
 * them. */
DrawFurniture drawBoardTable, drawBoardBench, drawBoardRack;

/** A room or a street; z is up, the origin the middle of the floor or the road. */
struct Site {
  Scene scene;
  /** Length, width and height of a room or, without height, a road [m]. */
  Vector3d size = Vector3d::Zero();
  /** Angle between the length and the x axis [rad]. */
  double yaw = 0.0;
};

/** Makes a room with doors, niches, furniture, tilted boards and round clutter. */
Site
makeRoom (Seed seed);

/** Makes a floor and two walls with tables, benches and racks of boards on posts:
 * narrow planes beside wide ones. */
Site
makeFurnishedCorner (Seed seed);

/** Counts the surfaces in the view of a depth camera; 0 if a shape is just in front of
 * the camera. */
int
countVisibleSurfaces (const Scene& scene, const Isometry3d& pose);

/** Draws a camera pose at a person's height, with little roll, looking somewhat
 * downwards, from where many surfaces are visible. */
Isometry3d
drawCameraPose (const Site& room, Seed seed);

/** Draws camera poses on three quarters of a turn around the middle of a room. The
 * camera looks across the middle; walls leave the view, and the first one returns. */
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

/** Draws lidar poses along the right lane, in equal steps of up to 1 m. They are spread
 * around the street's middle over at most half its length; the car sways a little. */
Poses
drawDrive (const Site& street, std::size_t frames, Seed seed);

/** Four walls and a gable roof; the ridge is along the length. */
struct House {
  Vector3d center = Vector3d::Zero(); // of the building on the ground [m]
  double yaw = 0.0;                   // from the x axis to the length [rad]
  double length = 15.0, width = 11.0; // [m]
  double eaves = 5.0, ridge = 8.0;    // heights above center [m]

  Isometry3d
  pose () const
  {
    return at (center) * turnZ (yaw);
  }
};

/** Houses on a square of ground. The origin is the middle of the ground; z is up. */
struct Survey {
  std::vector<House> houses;
  double width = 0.0; // edge of the ground [m]
};

/** Standard deviation of a surveyed point along each axis [m]. */
constexpr double survey_sigma = 0.015;

/** Makes 36 houses in six rows, each on a lot of 30 m x 30 m. */
Survey
makeSurvey (Seed seed);

/** Scans all walls and roofs with equal density, and the ground around the houses with
 * half of it. The points are in random order.
 * \param[in] noise factor on \ref survey_sigma */
SimulatedCloud
scanSurvey (const Survey& survey, std::size_t points, double noise, Seed seed);

/** Terraces of houses along streets, on level ground, surveyed in square tiles. Each
 * surface is divided into patches, each with its own random numbers. So the points of a
 * place depend neither on the size of the town nor on the borders of the tiles. */
struct Town {
  Seed seed = 1;
  std::uint32_t tiles = 1; // number along each side
  double tile = 100.0;     // edge of a tile [m]
  /** South-western corner, far from zero as in projected map coordinates [m]. */
  Vector3d corner = {691'000.0, 5'334'000.0, 519.0};
};

struct TownPoint {
  Vector3d position;
  std::uint32_t label = 0; // surface; the ground is 1
};

/** \param[in] points approximate number of points of the town
 * \param[in] tiles number of tiles, rounded up to a square number */
Town
makeTown (Seed seed, double points, double tiles);

std::vector<TownPoint>
surveyTile (const Town& town, std::uint32_t column, std::uint32_t row, double noise);

/** Standard deviation of the points of shapes [m]. */
constexpr double shapes_sigma = 0.002;

/** Scans a sphere, a cylinder, a cone and a torus in a row, parts of four larger ones
 * behind them, and beside them a ground with a board on it. The round shapes are apart
 * from each other. Their radii are 0.1 to 5.5 m: up to about 100 of the finer voxels in
 * which the default detector looks for planes. All surfaces get points with equal
 * density, also hidden ones; z is up. */
SimulatedCloud
simulateShapes (std::size_t points, double noise, Seed seed);

struct Simulation {
  std::string scene = "room";
  Seed seed = 1;
  DepthCamera camera = {}; // for rooms, corners with furniture, walks and tables
  bool has_raw_depth = false;
  std::string sensor = "lidar-64"; // for streets and drives
  double noise = 1.0;              // factor on the noise
  /** Number of points of scans without a sensor position. nullopt: the default of the
   * scene; a room is then seen by the camera. */
  std::optional<double> points = std::nullopt;
  bool organized = false;

  bool
  hasLidar () const
  {
    return scene == "street" || scene == "drive";
  }
};

/** Simulates one cloud of any scene except walk, drive and town. */
SimulatedCloud
simulate (const Simulation& simulation);

struct SensorView {
  Scene scene;
  Poses poses;
  std::function<Scan (std::size_t frame)> scan; // scan from poses[frame]
};

/** Returns the view of a camera in a room or on a walk, or of a lidar in a street or on
 * a drive. */
SensorView
viewOf (const Simulation& simulation, std::size_t frames = 1);

/** Root mean square pose errors: a value x is a rotation of x degrees and a shift of x
 * centimeters. */
struct PoseErrors {
  /** Error of each pose by itself; error of each step, which accumulates. */
  double each = 0.0, drift = 0.0;
};

/** Returns the poses with random errors, as a measurement gives them. */
Poses
measured (const Poses& poses, const PoseErrors& errors, Seed seed);

} // namespace pcl_ops::simulation
