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

/** \brief The tiles that tell the noise of all: evenly spread, with some hundred
 * thousand points together, or all of a small survey.
 * \param[in] points of each tile */
std::vector<std::size_t>
tilesThatTell (const std::vector<std::uint64_t>& points);

/** \brief Gets the own points of a tile in its frame. */
using PointsOfTile = std::function<std::vector<Eigen::Vector3f> (const TileKey& tile)>;

/** \brief What the survey says of its noise, which each tile is given: by itself a tile
 * of hills finds planes that the whole has not.
 * \param[in] tiles that tell it */
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
