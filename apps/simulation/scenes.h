// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "simulated_cloud.h"

namespace pcl_ops::simulation {

/** \brief A room or a street around a sensor; z is up, z = 0 the floor or the road, the
 * origin its middle. */
struct Site {
  Scene scene;
  /** \brief Length, width and height of a room; length of a street, and width of its
   * road between the curbs [m]. */
  Vector3d size = Vector3d::Zero();
  /** \brief Of the length against the x axis [rad]. */
  double yaw = 0.0;
};

/** \brief Draws a room with doors, niches, furniture, tilted boards and round clutter.
 */
Site
makeRoom (Seed seed);

/** \brief Draws the corner of a room, a floor and two walls, with tables, benches and
 * racks of boards on posts: narrow planes beside wide ones. */
Site
makeFurnishedCorner (Seed seed);

/** \brief Number of surfaces well in view of a depth camera, none if something stands
 * just before it. */
int
countVisibleSurfaces (const Scene& scene, const Isometry3d& pose);

/** \brief Draws a pose at a person's height in the room, upright to a few degrees, that
 * sees many surfaces and has nothing just in front of it. */
Isometry3d
drawCameraPose (const Site& room, Seed seed);

/** \brief Draws a walk through a room: three quarters of the way around its middle,
 * looking across it, so that walls come and go and the first comes again; at a person's
 * height, which rises and falls with the steps. */
Poses
drawWalk (const Site& room, std::size_t frames, Seed seed);

/** \brief Draws a straight road between curbs and sloping sidewalks, with houses,
 * parked cars, trees, bushes and poles on both sides. */
Site
makeStreet (Seed seed);

/** \brief Draws where a car in the right lane near the middle carries a sensor, in its
 * axes x forward, y left, z up: 1.7 to 1.9 m above the road, tilted by up to a degree.
 */
Isometry3d
drawSensorPose (const Site& street, Seed seed);

/** \brief Draws a drive along the right lane through the middle of a street, in equal
 * steps of up to 1 m and over at most half of it; the car sways a little. */
Poses
drawDrive (const Site& street, std::size_t frames, Seed seed);

/** \brief Four walls and a gable roof; the ridge is along the length. */
struct House {
  Vector3d center = Vector3d::Zero(); // of the building on the ground [m]
  double yaw = 0.0;                   // of the length against the x axis [rad]
  double length = 15.0, width = 11.0; // [m]
  double eaves = 5.0, ridge = 8.0;    // heights of the roof's edges [m]
};

/** \brief Houses on a square of ground; z is up, z = 0 the ground, the origin its
 * middle. */
struct Survey {
  std::vector<House> houses;
  double width = 0.0; // edge of the ground [m]
};

/** \brief Standard deviation of a surveyed point along each axis [m]. */
constexpr double survey_sigma = 0.015;

constexpr std::size_t houses_of_survey = 36, points_of_survey = 600'000;

/** \brief Draws houses in rows, each on 30 m x 30 m: 180 m x 180 m for 36 of them. */
Survey
makeSurvey (Seed seed, std::size_t houses = houses_of_survey);

/** \brief Surveys all walls, roofs and the ground around them evenly, the ground at
 * half the density, from no known position: the sensor's origin is 0 0 0. The points
 * come in no order.
 * \param[in] points exact number of points; none if there is no house
 * \param[in] noise factor on \ref survey_sigma */
SimulatedCloud
scanSurvey (const Survey& survey, std::size_t points, double noise, Seed seed);

/** \brief Terraces of houses along streets, on a level ground, surveyed in square
 * tiles.
 *
 * Each surface is divided into patches with points of their own, so that the points of
 * a place are the same however large the town is and wherever borders of tiles are. */
struct Town {
  Seed seed = 1;
  std::uint32_t tiles = 1; // along each side
  double tile = 100.0;     // edge of one [m]
  /** \brief South-western corner: far from zero, as such coordinates are [m]. */
  Vector3d corner = {691'000.0, 5'334'000.0, 519.0};
};

/** \brief A point and its true plane, from 1 on: the ground is 1. */
struct TownPoint {
  Vector3d position;
  std::uint32_t label = 0;
};

/** \brief A town with about so many points.
 * \param[in] tiles all of them, rounded up to a square number */
Town
makeTown (Seed seed, double points, double tiles);

/** \param[in] noise factor on \ref survey_sigma */
std::vector<TownPoint>
surveyTile (const Town& town, std::uint32_t column, std::uint32_t row, double noise);

/** \brief Standard deviation of the points of shapes [m]. */
constexpr double shapes_sigma = 0.002;

/** \brief About 5000 points on a square meter. */
constexpr std::size_t points_of_shapes = 250'000;

/** \brief A sphere, a cylinder, a cone and a torus in a row, behind them parts of four
 * larger ones, apart from each other and from a ground and a board on it. The radii are
 * from 0.1 to 5.5 m: up to some 100 of the finer voxels that the default detector looks
 * for planes in. All surfaces are scanned evenly, whatever hides them, from no known
 * position; z is up, z = 0 the ground. */
SimulatedCloud
simulateShapes (std::size_t points, double noise, Seed seed);

} // namespace pcl_ops::simulation
