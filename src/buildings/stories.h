// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

namespace pcl_ops::internal::buildings {

/** \brief A level plane: its height, its area and the side it was seen from. */
struct LevelPlane {
  double height, area;
  bool faces_down;
  /** \brief Seen from above for certain, which no ceiling is. */
  bool is_below_sensor = false;
};

/** \brief Level planes at one height, within a hand. */
struct Level {
  double height, area;
  bool faces_down;
  bool is_below_sensor = false;
};

/** \brief Heights of what is stood on and of what is overhead. */
struct Story {
  double floor;
  std::optional<double> ceiling = {};
  /** \brief Of the floor's level [m^2]; 0 where no floor was seen. */
  double area = 0.0;
};

/** \brief Level planes by height, those within 15 cm together, ascending. */
std::vector<Level>
levelsOf (std::vector<LevelPlane> planes);

/** \brief Stories from the lowest up, at least one: a level of less than a fifth of the
 * largest one's area, or of less than a square meter, makes none. The lowest level is
 * the first floor if it is a step above the lowest plane, or less, or as large as no
 * furniture is. What lies below the sensor is no ceiling.
 * \param[in] levels ascending [m]
 * \param[in] lowest of all planes, of level ones their middle: the floor of the first
 * story where none was seen */
std::vector<Story>
storiesOf (const std::vector<Level>& levels, double lowest);

/** \brief The one a height belongs to: the highest with its floor below. */
const Story&
storyAt (const std::vector<Story>& stories, double height);

} // namespace pcl_ops::internal::buildings
