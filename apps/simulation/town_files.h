// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "town.h"
#include <cli/progress.h>

#include <cstdint>
#include <string>

namespace pcl_ops::simulation {

/** \brief How many files there are, and points in them. */
struct TownFiles {
  std::uint64_t files = 0, points = 0;
};

/** \brief Of the squares of so many tiles along a side the first with so many or more.
 */
std::uint32_t
tilesAlongASide (double tiles);

/** \brief Writes each tile as FOLDER/town_000_000.las and so on, column and row, with
 * one tile in memory. Tiles without points have no file.
 * \param[in,out] progress of all tiles
 * \throws WorkError if one cannot be written */
TownFiles
saveTown (const std::string& folder,
          const Town& town,
          double noise_scale,
          apps::Progress& progress);

} // namespace pcl_ops::simulation
