// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plan.h"
#include "run_files.h"
#include <cli/errors.h>
#include <cli/program.h>
#include <io/las_file.h>

#include <filesystem>
#include <functional>
#include <system_error>

namespace pcl_ops::apps {

/** \brief Names of files in \ref RunFolder::work. */
namespace run_file {
inline constexpr const char* plan = "plan.json";
/** \brief The list of planes before it becomes planes.json, with a checksum. */
inline constexpr const char* list = "planes/planes.json";
/** \brief The noise of the survey. */
inline constexpr const char* noise = "planes/noise";
/** \brief An empty file that marks a finished run. */
inline constexpr const char* end_mark = "done";
} // namespace run_file

/** \brief Name of the list of planes among the outputs. */
inline constexpr const char* planes_file = "planes.json";

/** \brief Paths of the outputs of a run, and of the intermediate files that a phase
 * writes for later ones. The parameter input is a position in \ref Plan::inputs. */
struct RunFolder {
  /** \brief The folder of --output-dir. */
  std::string outputs;

  /** \brief Path of an output. */
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

  /** \brief Path of the points of an input, sorted by tiles (\ref BlockFileWriter). */
  std::string
  blocks (std::size_t input) const
  {
    return work ("cells/" + std::to_string (input) + ".cells");
  }

  /** \brief Path of a file about a tile.
   * \param[in] extension .planes for its \ref TilePlanes; .numbers for the list of the
   * numbers that the planes of its pieces have in planes.json; or that of \ref
   * pieceNumbers */
  std::string
  ofTile (const TileKey& tile, const std::string& extension) const
  {
    return work ("planes/" + std::to_string (tile[0]) + "_" + std::to_string (tile[1]) +
                 extension);
  }

  /** \brief Path of the piece numbers (TileDetection::piece_numbers) of a tile's own
   * points of one input, in the order of the points. */
  std::string
  pieceNumbers (const TileKey& tile, std::size_t input) const
  {
    return ofTile (tile, "." + std::to_string (input) + ".labels");
  }

  /** \brief Path of an empty file that marks an input whose output is written. */
  std::string
  labeledMark (std::size_t input) const
  {
    return work ("labelled/" + std::to_string (input));
  }

  /** \brief Makes the folders that are missing. \throws WorkError */
  void
  makeFolders () const;

  /** \brief Removes the files of all phases and the mark of a finished run, but not the
   * plan. \throws WorkError */
  void
  removeEarlierRun () const;

  /** \brief Removes the files of all phases, but neither the plan nor the mark of a
   * finished run. \return the first error */
  std::error_code
  removePhaseFiles () const;

  /** \brief Last phase: writes planes.json and the mark of a finished run.
   * \param[in] with_warnings gets the text of the list of planes (\ref run_file::list)
   * and returns it with warnings added
   * \throws WorkError if that list is damaged or a file cannot be written */
  void
  finish (const std::function<std::string (const std::string&)>& with_warnings) const;
};

/** \brief Returns the result of \p work, which is a run or a part of it.
 * \throws WorkError in place of \ref Interrupted, whose message does not say that a later
 * run goes on; and whatever else \p work throws */
template <typename Work>
auto
asResumable (Work&& work)
{
  try {
    return work();
  }
  catch (const Interrupted&) {
    throw WorkError ("interrupted", "no output is half-written; run it again to go on");
  }
}

/** \brief Whether a file or folder exists. */
inline bool
isThere (const std::string& file)
{
  std::error_code error;
  return std::filesystem::exists (file, error);
}

/** \brief First phase, for each input: writes the points in reach of the grid, sorted
 * by the tiles that see them. */
void
partitionInput (const Plan& plan, const RunFolder& folder, std::size_t input);

/** \brief The points of all inputs as \ref partitionInput has sorted them. */
struct SortedPoints {
  /** \brief Reads the indexes of the files, but no points. */
  SortedPoints (const Plan& plan, const RunFolder& folder);

  /** \brief One for each input. */
  std::vector<BlockFile> files;
  /** \brief All tiles with own points (TilePart::Own) in ascending order. */
  std::vector<TileKey> tiles;
  /** \brief Number of own points of each of these tiles. */
  std::vector<std::uint64_t> points_of_tile;
};

/** \brief Second phase, for the whole survey: writes its noise to a file for \ref
 * detectTile. Writes nothing if planes are found on voxels, which need no noise of the
 * survey, or if there is a single tile, which measures its own noise. */
void
measureSurvey (const Plan& plan, const RunFolder& folder, const SortedPoints& points);

/** \brief Third phase, for each tile: finds the planes of the points that it sees, and
 * writes the piece numbers of its own points and its pieces of planes. The file of
 * pieces comes last: it marks a finished tile. */
void
detectTile (const Plan& plan,
            const RunFolder& folder,
            const SortedPoints& points,
            const TileKey& tile);

/** \brief Fourth phase, for the whole survey: joins the pieces of all tiles to planes,
 * and writes the plane of each piece and the list of planes. The list comes last: it
 * marks the finished phase. */
void
joinTiles (const Plan& plan, const RunFolder& folder, const SortedPoints& points);

/** \brief Fifth phase, for each input: writes it with the labels of its points, then
 * the mark of \ref RunFolder::labeledMark. */
void
labelInput (const Plan& plan, const RunFolder& folder, std::size_t input);

/** \brief Path of the labeled copy of an input. */
std::string
outputOf (const Plan& plan, const RunFolder& folder, std::size_t input);

/** \brief Visits all points of the outputs of a finished run, with their labels.
 * \throws WorkError if an output cannot be read or has no labels */
void
forEachLabeledPoint (const Plan& plan,
                     const RunFolder& folder,
                     const VisitLabeledPosition& visit);

} // namespace pcl_ops::apps
