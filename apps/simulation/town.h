// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene.h"

namespace pcl_ops::simulation {

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

} // namespace pcl_ops::simulation
