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
 * a survey of less than 800,000 points; else some, evenly spread, with about 400,000
 * points or one tile if that has more. If all tiles have equally many points, the
 * chosen ones have at least two thirds of 400,000.
 * \return their positions in the list
 * \param[in] points_of_tile number of points of each tile */
std::vector<std::size_t>
tilesToMeasure (const std::vector<std::uint64_t>& points_of_tile);

/** \brief Returns the own points of a tile, in the frame of the tile. */
using PointsOfTile = std::function<std::vector<Eigen::Vector3f> (const TileKey& tile)>;

/** \brief Measures the noise of the survey, which detection in all tiles uses. A tile
 * of hills, searched with its own noise, has planes that the whole survey does not
 * have.
 * \param[in] tiles in which the noise is measured
 * \param[in] points_of called once for each of them */
CloudNoise
noiseOfSurvey (const Plan& plan,
               const std::vector<TileKey>& tiles,
               const PointsOfTile& points_of);

/** \brief Writes the file in one step. \throws WorkError if it cannot be written */
void
saveNoise (const std::string& file, const CloudNoise& noise);

/** \throws WorkError if the file cannot be read */
CloudNoise
loadNoise (const std::string& file);

} // namespace pcl_ops::apps
