// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "simulated_cloud.h"

namespace pcl_ops::simulation {

/** Four walls and a gable roof; the ridge is along the length, in the middle of the
 * width.
 */
struct House {
  Vector3d center = Vector3d::Zero(); // of the building on the ground [m]
  double yaw = 0.0;                   // from the x axis to the length [rad]
  double length = 15.0, width = 11.0; // [m]
  double eaves = 5.0, ridge = 8.0;    // heights above center [m]

  /** Returns the transform from the frame of the house, with x along its length and z
   * up.
   */
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

} // namespace pcl_ops::simulation
