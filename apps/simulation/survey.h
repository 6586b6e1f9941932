// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "simulated_cloud.h"

namespace pcl_ops::simulation {

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

} // namespace pcl_ops::simulation
