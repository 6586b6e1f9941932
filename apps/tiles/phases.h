// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plan.h"
#include "run_files.h"
#include <io/las_file.h>

#include <filesystem>
#include <functional>
#include <system_error>

namespace pcl_ops::apps {

/** \brief Names of \ref RunFolder::work: the plan that all other files are of, what
 * planes.json becomes once all else is done, and the end. */
namespace run_file {
inline constexpr const char *plan = "plan.json", *list = "planes/planes.json",
                            *noise = "planes/noise", *end = "done";
} // namespace run_file

inline constexpr const char* planes_file = "planes.json";

/** \brief Where the files of a run are, which its phases leave for one another. */
struct RunFolder {
  std::string outputs;

  std::string
  output (const std::string& name) const
  {
    return (std::filesystem::path (outputs) / name).string();
  }

  /** \brief Where a file is that is no output. */
  std::string
  work (const std::string& name) const
  {
    return output ("work/" + name);
  }

  std::string
  cells (std::size_t input) const
  {
    return work ("cells/" + std::to_string (input) + ".cells");
  }

  /** \param[in] extension .planes; .numbers of these planes in the list of all; or that
   * of \ref labels */
  std::string
  ofTile (const TileKey& tile, const std::string& extension) const
  {
    return work ("planes/" + std::to_string (tile[0]) + "_" + std::to_string (tile[1]) +
                 extension);
  }

  /** \brief The labels of a tile's own points of one input, in their order. */
  std::string
  labels (const TileKey& tile, std::size_t input) const
  {
    return ofTile (tile, "." + std::to_string (input) + ".labels");
  }

  std::string
  mark (std::size_t input) const
  {
    return work ("labelled/" + std::to_string (input));
  }

  /** \brief Makes the folders that are missing. \throws WorkError */
  void
  make () const;

  /** \brief Removes all but the plan. \throws WorkError */
  void
  empty () const;

  /** \brief Removes all but the plan and the end. */
  std::error_code
  clean () const;

  /** \brief Writes planes.json and the end: all else is done.
   * \param[in] amended makes of the list of planes what is written */
  void
  finish (const std::function<std::string (const std::string&)>& amended) const;
};

inline bool
isThere (const std::string& file)
{
  std::error_code error;
  return std::filesystem::exists (file, error);
}

void
partitionInput (const Plan& plan, const RunFolder& folder, std::size_t input);

struct SortedPoints {
  SortedPoints (const Plan& plan, const RunFolder& folder);

  /** \brief Of each input. */
  std::vector<CellFile> files;
  /** \brief All tiles with points, sorted, and how many points each has. */
  std::vector<TileKey> tiles;
  std::vector<std::uint64_t> points_of_tile;
};

/** \brief Leaves what the survey says of its noise, which its tiles are given. One tile
 * finds it out by itself. */
void
measureSurvey (const Plan& plan, const RunFolder& folder, const SortedPoints& points);

void
detectTile (const Plan& plan,
            const RunFolder& folder,
            const SortedPoints& points,
            const TileKey& tile);

void
joinTiles (const Plan& plan, const RunFolder& folder, const SortedPoints& points);

void
labelInput (const Plan& plan, const RunFolder& folder, std::size_t input);

std::string
outputOf (const Plan& plan, const RunFolder& folder, std::size_t input);

/** \brief Visits all points of a run that is done, with their labels.
 * \throws WorkError if an output cannot be read or has no labels */
void
forLabelledPoints (const Plan& plan,
                   const RunFolder& folder,
                   const VisitLabelled& visit);

} // namespace pcl_ops::apps
