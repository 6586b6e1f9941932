// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

namespace pcl_ops::internal::buildings {

/** \brief A level plane: the height of its middle [m], its area [m^2] and the side it
 * was seen from. */
struct LevelPlane {
  double height, area;
  /** \brief Whether its normal points down, as it was seen from below. False, too, if
   * the sensor is unknown. */
  bool faces_down;
  /** \brief Whether it lies below the sensor, which saw it from above. */
  bool is_below_sensor = false;
};

/** \brief Level planes at most same_level (constants.h) above the lowest of them: their
 * mean height [m], weighted by area, and their total area [m^2]. Each flag is set if it
 * is set for planes with more than half of the area. */
struct Level {
  double height, area;
  bool faces_down;
  bool is_below_sensor = false;
};

/** \brief Heights of the floor and of the ceiling of a story [m]. */
struct Story {
  double floor;
  std::optional<double> ceiling = {};
  /** \brief Area of the floor's level [m^2]; 0 if no floor was seen. */
  double area = 0.0;
};

/** \brief Groups level planes into levels; returns the levels by ascending height. */
std::vector<Level>
levelsOf (std::vector<LevelPlane> planes);

/** \brief Returns the stories from the lowest up, at least one. Names of limits are
 * those of constants.h.
 * - A level smaller than min_level_area, or than min_share_of_largest_level of the
 *   largest one, is ignored.
 * - The lowest level left is the first floor if it was not seen from below and is less
 *   than max_step above \p lowest. If it is larger than furniture (min_ground_area), it
 *   may be less than headroom above \p lowest, or at any height below the sensor.
 * - Any other level less than headroom above the floor of the last story is ignored.
 * - A level left is the ceiling of the last story if it was seen from below.
 * - Else, while that story has no ceiling: a highest level smaller than
 *   min_ceiling_share_of_floor of the floor is ignored. The highest level, or one up to
 *   max_deck_thickness below a floor, is the ceiling unless it is below the sensor.
 * - Else it is the floor of the next story.
 * \param[in] levels ascending
 * \param[in] lowest height of the lowest plane [m], of its middle if it is level: the
 * floor of the first story if no floor was seen */
std::vector<Story>
storiesOf (const std::vector<Level>& levels, double lowest);

/** \brief Returns the story that a height [m] belongs to: the highest one whose floor
 * is not above \p height + same_level, or else the first.
 * \param[in] stories at least one, from the lowest up */
const Story&
storyAt (const std::vector<Story>& stories, double height);

} // namespace pcl_ops::internal::buildings
