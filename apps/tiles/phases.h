// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cell_file.h"
#include "plan.h"
#include "tile_grid.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl_ops::apps {

/** \brief Where the files of a run are, which its phases leave for one another. */
struct RunFolder {
  std::string outputs;

  std::string
  output (const std::string& name) const;

  /** \brief Where a file is that is no output. */
  std::string
  work (const std::string& name) const
  {
    return output ("work/" + name);
  }

  /** \brief Where the plan is that all other files are of. */
  std::string
  plan () const
  {
    return work ("plan.json");
  }
  std::string
  cells (std::size_t input) const
  {
    return work ("cells/" + std::to_string (input) + ".cells");
  }
  /** \param[in] extension .planes or .labels */
  std::string
  ofTile (const TileKey& tile, const char* extension) const
  {
    return work ("planes/" + std::to_string (tile.x) + "_" + std::to_string (tile.y) +
                 extension);
  }
  std::string
  numbers () const
  {
    return work ("planes/numbers");
  }
  /** \brief What planes.json becomes once all else is done. */
  std::string
  list () const
  {
    return work ("planes/planes.json");
  }
  std::string
  mark (std::size_t input) const
  {
    return work ("labelled/" + std::to_string (input));
  }
  std::string
  end () const
  {
    return work ("done");
  }

  /** \brief Makes the folders that are missing. \throws WorkError */
  void
  make () const;

  /** \brief Removes all but the plan, and makes the folders again. \throws WorkError */
  void
  startAnew () const;

  /** \brief Removes all but the plan and \ref end. */
  void
  clean () const;
};

bool
isThere (const std::string& file);

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
