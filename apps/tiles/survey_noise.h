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

/** \return positions of the tiles in which the noise of the survey is measured: evenly
 * spread, with some hundred thousand points together; all tiles of a small survey
 * \param[in] points number of points of each tile */
std::vector<std::size_t>
tilesThatTell (const std::vector<std::uint64_t>& points);

/** \brief Returns the own points of a tile, in the frame of the tile. */
using PointsOfTile = std::function<std::vector<Eigen::Vector3f> (const TileKey& tile)>;

/** \brief Measures the noise of the survey, for detection in all tiles. With the noise
 * of a tile of hills alone, planes are found that the whole survey does not have.
 * \param[in] tiles in which it is measured */
CloudNoise
noiseOfSurvey (const Plan& plan,
               const std::vector<TileKey>& tiles,
               const PointsOfTile& points_of);

/** \brief Writes it in one step. \throws WorkError if it cannot be written */
void
saveNoise (const std::string& file, const CloudNoise& noise);

/** \throws WorkError if it cannot be read */
CloudNoise
loadNoise (const std::string& file);

} // namespace pcl_ops::apps
