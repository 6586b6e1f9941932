// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "simulated_cloud.h"
#include "town.h"
#include <cli/progress.h>

#include <cstdint>
#include <functional>
#include <string>

namespace pcl_ops::simulation {

/** \brief How many files there are, and points in them. */
struct WrittenFiles {
  std::uint64_t files = 0, points = 0;
};

/** \brief Writes each tile as FOLDER/town_000_000.las and so on, column and row, with
 * one tile in memory. Tiles without points have no file.
 * \throws WorkError if one cannot be written */
WrittenFiles
saveTown (const std::string& folder,
          const Town& town,
          double noise_scale,
          apps::Progress& progress);

/** \brief Writes the clouds of a walk or a drive as FOLDER/frame_000.pcd and so on.
 * \throws WorkError if one cannot be written */
WrittenFiles
saveFrames (const std::string& folder,
            std::size_t frames,
            const std::function<LabeledCloud (std::size_t)>& look,
            apps::Progress& progress);

} // namespace pcl_ops::simulation
