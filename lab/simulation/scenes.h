// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "sensors.h"

#include <functional>
#include <optional>

namespace pcl_ops::simulation {

/** A piece stands on z = 0 around the origin, its back towards -y. */
using DrawFurniture = Body (Random& random);

/** A desk, a cupboard, a shelf, a bed, a sofa or a leaning board. */
DrawFurniture drawAtWall;
/** A table, a chair, cartons, a panel of any tilt, or round things. */
DrawFurniture drawAnywhere;
DrawFurniture drawLeaningBoard, drawRamp;
/** A ball, a bin, a lamp or a rolled carpet: nothing planar. */
DrawFurniture drawRoundClutter;

/** Boards on four square posts, 2 to 6 cm thick. Each face is a plane of its own,
 * however narrow; no two faces of a piece are in one plane, where a detector could
 * rightly call them one. */
DrawFurniture drawBoardTable, drawBoardBench, drawBoardRack;

/** A room or a street; z is up, the origin the middle of the floor or the road. */
struct Site {
  Scene scene;
  /** Length, width and height of a room or, without height, a road [m]. */
  Vector3d size = Vector3d::Zero();
  /** Of the length against the x axis [rad]. */
  double yaw = 0.0;
};

/** With doors, niches, furniture, tilted boards and round clutter. */
Site
makeRoom (Seed seed);

/** A floor and two walls, with tables, benches and racks of boards on posts: narrow
 * planes beside wide ones. */
Site
makeFurnishedCorner (Seed seed);

/** In view of a depth camera; none if something stands just before it. */
int
countVisibleSurfaces (const Scene& scene, const Isometry3d& pose);

/** At a person's height, upright to a few degrees, with many surfaces in view. */
Isometry3d
drawCameraPose (const Site& room, Seed seed);

/** Three quarters of the way around the middle of a room, looking across it, so that
 * walls come and go and the first comes again. */
Poses
drawWalk (const Site& room, std::size_t frames, Seed seed);

/** A straight road between curbs and sloping sidewalks, with houses, parked cars,
 * trees, bushes and poles on both sides. */
Site
makeStreet (Seed seed);

/** On a car in the right lane near the middle, in the axes x forward, y left, z up. */
Isometry3d
drawSensorPose (const Site& street, Seed seed);

/** Along the right lane through the middle of a street, in equal steps of up to 1 m and
 * over at most half of it; the car sways a little. */
Poses
drawDrive (const Site& street, std::size_t frames, Seed seed);

/** Four walls and a gable roof; the ridge is along the length. */
struct House {
  Vector3d center = Vector3d::Zero(); // of the building on the ground [m]
  double yaw = 0.0;                   // of the length against the x axis [rad]
  double length = 15.0, width = 11.0; // [m]
  double eaves = 5.0, ridge = 8.0;    // heights of the roof's edges [m]

  Isometry3d
  pose () const
  {
    return at (center) * turnZ (yaw);
  }
};

/** Houses on a square of ground, whose middle is the origin; z is up. */
struct Survey {
  std::vector<House> houses;
  double width = 0.0; // edge of the ground [m]
};

/** Standard deviation of a surveyed point along each axis [m]. */
constexpr double survey_sigma = 0.015;

/** 36 houses in rows, each on 30 m x 30 m. */
Survey
makeSurvey (Seed seed);

/** All walls, roofs and the ground around them evenly, the ground at half the density,
 * in no order.
 * \param[in] noise factor on \ref survey_sigma */
SimulatedCloud
scanSurvey (const Survey& survey, std::size_t points, double noise, Seed seed);

/** Terraces of houses along streets, on a level ground, surveyed in square tiles. Each
 * surface is divided into patches with points of their own, so that the points of a
 * place are the same however large the town is and wherever borders of tiles are. */
struct Town {
  Seed seed = 1;
  std::uint32_t tiles = 1; // along each side
  double tile = 100.0;     // edge of one [m]
  /** South-western corner: far from zero, as such coordinates are [m]. */
  Vector3d corner = {691'000.0, 5'334'000.0, 519.0};
};

struct TownPoint {
  Vector3d position;
  std::uint32_t label = 0; // from 1 on: the ground is 1
};

/** \param[in] points about how many
 * \param[in] tiles all of them, rounded up to a square number */
Town
makeTown (Seed seed, double points, double tiles);

std::vector<TownPoint>
surveyTile (const Town& town, std::uint32_t column, std::uint32_t row, double noise);

/** Standard deviation of the points of shapes [m]. */
constexpr double shapes_sigma = 0.002;

/** A sphere, a cylinder, a cone and a torus in a row, behind them parts of four larger
 * ones, apart from each other and from a ground and a board on it. The radii are from
 * 0.1 to 5.5 m: up to some 100 of the finer voxels that the default detector looks for
 * planes in. All surfaces are scanned evenly, whatever hides them; z is up. */
SimulatedCloud
simulateShapes (std::size_t points, double noise, Seed seed);

struct Simulation {
  std::string scene = "room";
  Seed seed = 1;
  DepthCamera camera = {}; // of rooms, corners with furniture, walks and tables
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
