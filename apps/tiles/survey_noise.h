// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plan.h"
#include "tile_grid.h"
#include <pcl_ops/detection_report.h>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace pcl_ops::apps {

/** \brief Chooses the tiles in which the noise of the survey is measured: all tiles of
 * a survey of fewer than 800,000 points; else some tiles, evenly spread over the list,
 * that have about 400,000 points together, or one tile if that has more. If all tiles
 * have equally many points, the chosen ones have at least two thirds of 400,000.
 * \return positions of the tiles in \p points_of_tile, ascending
 * \param[in] points_of_tile number of points of each tile */
std::vector<std::size_t>
tilesToMeasure (const std::vector<std::uint64_t>& points_of_tile);

/** \brief Returns the points in a tile without its halo, in the frame of the tile. */
using PointsOfTile = std::function<std::vector<Eigen::Vector3f> (const TileKey& tile)>;

/** \brief Measures the noise of the survey, for the detection in all tiles. If a tile
 * of hills were searched with its own noise, planes would be found that a search of the
 * whole survey does not find.
 * \param[in] tiles in which the noise is measured
 * \param[in] points_of called once for each of them */
CloudNoise
noiseOfSurvey (const Plan& plan,
               const std::vector<TileKey>& tiles,
               const PointsOfTile& points_of);

/** \brief Writes the file in one step. \throws WorkError if it cannot be written */
void
saveNoise (const std::string& file, const CloudNoise& noise);

/** \brief Reads a file of \ref saveNoise. \throws WorkError if it cannot be read */
CloudNoise
loadNoise (const std::string& file);

} // namespace pcl_ops::apps
