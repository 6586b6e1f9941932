// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene.h"

namespace pcl_ops::simulation {

/** Terraces of houses along streets, on level ground, surveyed in square tiles. Each
 * surface is divided into patches, each with its own random numbers. So the points of a
 * patch depend neither on the size of the town nor on the borders of the tiles. */
struct Town {
  Seed seed = 1;
  std::uint32_t tiles = 1;     // number along each side
  double edge_of_tile = 100.0; // [m]
  /** South-western corner, far from zero as in projected map coordinates [m]. */
  Vector3d corner = {691'000.0, 5'334'000.0, 519.0};
};

struct TownPoint {
  Vector3d position;       // in map coordinates [m]
  std::uint32_t label = 0; // number of the surface; the ground has 1
};

/** Makes a town. Its area follows from the number of points, as their density is fixed.
 * \param[in] points approximate number of points of the town
 * \param[in] tiles number of tiles, rounded up to a square number */
Town
makeTown (Seed seed, double points, double tiles);

/** Returns the points of a tile.
 * \param[in] column, row of the tile, from 0 at the south-western corner on
 * \param[in] noise factor on survey_sigma (survey.h) */
std::vector<TownPoint>
surveyTile (const Town& town, std::uint32_t column, std::uint32_t row, double noise);

} // namespace pcl_ops::simulation
