// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cell_file.h"
#include "plan.h"
#include "run_folder.h"

#include <cstdint>
#include <vector>

namespace pcl_ops::apps {

inline constexpr const char* planes_file = "planes.json";

void
partitionInput (const Plan& plan, const RunFolder& folder, std::size_t input);

struct TileSize {
  TileKey tile;
  std::uint64_t points = 0;
};

class SortedPoints {
public:
  SortedPoints (const Plan& plan, const RunFolder& folder);

  /** \brief All tiles with points, those with most of them first. */
  const std::vector<TileSize>&
  tiles () const
  {
    return tiles_;
  }

  const std::vector<CellFile>&
  files () const
  {
    return files_;
  }

private:
  std::vector<CellFile> files_;
  std::vector<TileSize> tiles_;
};

void
detectTile (const Plan& plan,
            const RunFolder& folder,
            const SortedPoints& points,
            const TileKey& tile);

void
joinTiles (const Plan& plan, const RunFolder& folder, const SortedPoints& points);

void
labelInput (const Plan& plan, const RunFolder& folder, std::size_t input);

/** \brief Writes planes.json: all else is done. */
void
listPlanes (const RunFolder& folder);

std::string
outputOf (const Plan& plan, const RunFolder& folder, std::size_t input);

} // namespace pcl_ops::apps
