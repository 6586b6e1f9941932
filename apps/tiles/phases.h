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

/** \brief Names for \ref RunFolder::work: the plan of the run, the list of planes
 * before it becomes planes.json, the survey's noise, and the mark of a finished run. */
namespace run_file {
inline constexpr const char *plan = "plan.json", *list = "planes/planes.json",
                            *noise = "planes/noise", *end = "done";
} // namespace run_file

inline constexpr const char* planes_file = "planes.json";

/** \brief Paths of the outputs of a run and of the files its phases leave. */
struct RunFolder {
  std::string outputs;

  std::string
  output (const std::string& name) const
  {
    return (std::filesystem::path (outputs) / name).string();
  }

  /** \brief Path of an intermediate file. */
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

  /** \param[in] extension .planes for the pieces of a tile; .numbers for the number of
   * each piece's plane in planes.json; or that of \ref labels */
  std::string
  ofTile (const TileKey& tile, const std::string& extension) const
  {
    return work ("planes/" + std::to_string (tile[0]) + "_" + std::to_string (tile[1]) +
                 extension);
  }

  /** \brief Path of the labels of a tile's own points of one input, in the order of the
   * points. */
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

  /** \brief Removes the files of all phases and the mark of a finished run, but not the
   * plan. \throws WorkError */
  void
  empty () const;

  /** \brief Removes the files of all phases, but neither the plan nor the mark of a
   * finished run. \return the first error */
  std::error_code
  clean () const;

  /** \brief Writes planes.json and the mark of a finished run, as the last phase.
   * \param[in] amended makes the text of planes.json from the list of planes */
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

  /** \brief One for each input. */
  std::vector<CellFile> files;
  /** \brief All tiles with own points, sorted, and the number of own points of each. */
  std::vector<TileKey> tiles;
  std::vector<std::uint64_t> points_of_tile;
};

/** \brief Writes the noise of the whole survey to a file for \ref detectTile. Writes
 * nothing on voxels, or for a single tile, which measures its own noise. */
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

/** \brief Visits all points of the outputs of a finished run, with their labels.
 * \throws WorkError if an output cannot be read or has no labels */
void
forLabelledPoints (const Plan& plan,
                   const RunFolder& folder,
                   const VisitLabelled& visit);

} // namespace pcl_ops::apps
