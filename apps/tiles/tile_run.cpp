// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tile_run.h"

#include "phases.h"
#include "planes_json.h"
#include "planning.h"
#include "run_folder.h"
#include <cli/errors.h>
#include <cli/interruption.h>
#include <cli/parallel.h>
#include <cli/progress.h>
#include <io/output_file.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <iomanip>
#include <optional>
#include <ostream>
#include <sstream>

namespace pcl_ops::apps {

namespace {

std::string
textOf (const Plan& plan)
{
  std::ostringstream text;
  text << plan.points() << " points of " << plan.inputs.size()
       << (plan.inputs.size() == 1 ? " input" : " inputs") << ", cells of " << plan.cell
       << ", about " << plan.likely_tiles
       << (plan.likely_tiles == 1 ? " tile of " : " tiles of ")
       << plan.cell * static_cast<double> (plan.cells_of_tile);
  return text.str();
}

/** \brief A run of all phases, as one of the ranks has it. */
class TileRun {
public:
  TileRun (const Plan& plan,
           const RunFolder& folder,
           const TilesOptions& options,
           const Ranks& ranks,
           std::ostream& messages,
           bool is_terminal)
  : plan_ (plan)
  , folder_ (folder)
  , jobs_ (options.jobs)
  , ranks_ (ranks)
  , messages_ (messages)
  , style_ (ranks.rank() == 0 && !options.quiet ? progressStyleOf (is_terminal)
                                                : ProgressStyle::None)
  {}

  /** \return how long each phase took, in words */
  std::string
  run ()
  {
    sortPoints();
    const SortedPoints points (plan_, folder_);
    detectPlanes (points);
    if (ranks_.rank() == 0 && !isThere (folder_.numbers()))
      joinTiles (plan_, folder_, points);
    finish ("joined");
    labelPoints();
    return times_;
  }

private:
  void
  sortPoints ()
  {
    share (
        pointsOfInputs(),
        "inputs sorted",
        [this] (std::size_t i) { return isThere (folder_.cells (i)); },
        [this] (std::size_t i) {
          inMemory (plan_.inputs[i].file, fewer_jobs, [&] {
            partitionInput (plan_, folder_, i);
          });
        });
    finish ("sorted");
  }

  void
  detectPlanes (const SortedPoints& points)
  {
    const std::vector<TileSize>& tiles = points.tiles();
    std::vector<std::uint64_t> parts;
    parts.reserve (tiles.size());
    for (const TileSize& tile : tiles)
      parts.push_back (tile.points);
    share (
        parts,
        "tiles",
        [&] (std::size_t i) {
          return isThere (folder_.ofTile (tiles[i].tile, ".planes"));
        },
        [&] (std::size_t i) {
          inMemory ("--tile", "give a smaller one or fewer --jobs", [&] {
            detectTile (plan_, folder_, points, tiles[i].tile);
          });
        });
    finish ("planes found");
  }

  void
  labelPoints ()
  {
    share (
        pointsOfInputs(),
        "inputs labelled",
        [this] (std::size_t i) {
          return isThere (folder_.mark (i)) && isThere (outputOf (plan_, folder_, i));
        },
        [this] (std::size_t i) {
          inMemory (plan_.inputs[i].file, fewer_jobs, [&] {
            labelInput (plan_, folder_, i);
          });
        });
    finish ("labelled");
  }

  /** \brief Waits until all ranks are through a phase. */
  void
  finish (const std::string& phase)
  {
    ranks_.meet();
    const auto now = std::chrono::steady_clock::now();
    std::ostringstream text;
    text << std::fixed << std::setprecision (1) << (times_.empty() ? "" : ", ") << phase
         << " in " << std::chrono::duration<double> (now - start_).count() << " s";
    times_ += text.str();
    start_ = now;
  }

  std::vector<std::uint64_t>
  pointsOfInputs () const
  {
    std::vector<std::uint64_t> points;
    points.reserve (plan_.inputs.size());
    for (const PlannedInput& input : plan_.inputs)
      points.push_back (input.points);
    return points;
  }

  /** \brief Does this rank's share of the parts of a phase.
   * \param[in] parts how much work each is
   * \param[in] is_done whether a part is */
  void
  share (const std::vector<std::uint64_t>& parts,
         const std::string& noun,
         const std::function<bool (std::size_t)>& is_done,
         const std::function<void (std::size_t)>& work)
  {
    std::vector<std::size_t> own;
    for (const std::size_t part : shareOf (static_cast<std::size_t> (ranks_.rank()),
                                           static_cast<std::size_t> (ranks_.size()),
                                           parts))
      if (!is_done (part))
        own.push_back (part);
    Progress progress (own.size(), messages_, style_, noun);
    try {
      runInParallel (own.size(), jobs_, [&] (std::size_t i) {
        stopIfInterrupted();
        work (own[i]);
        progress.step();
      });
    }
    catch (const Interrupted&) {
      throw WorkError ("interrupted",
                       "no output is half-written; run it again to go on");
    }
  }

  static constexpr const char* fewer_jobs = "give fewer --jobs";

  const Plan& plan_;
  const RunFolder& folder_;
  unsigned jobs_;
  const Ranks& ranks_;
  std::ostream& messages_;
  ProgressStyle style_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::string times_;
};

/** \brief Whether a run has come to its end, and nobody has removed what it wrote. */
bool
isDone (const Plan& plan, const RunFolder& folder)
{
  bool all_are_there = isThere (folder.end()) && isThere (folder.output (planes_file));
  for (std::size_t i = 0; i < plan.inputs.size(); ++i)
    all_are_there = all_are_there && isThere (outputOf (plan, folder, i));
  return all_are_there;
}

} // namespace

void
runTiles (const TilesOptions& options,
          const Ranks& ranks,
          std::ostream& out,
          std::ostream& messages,
          bool is_terminal)
{
  const RunFolder folder{options.output_dir};
  const bool speaks = ranks.rank() == 0 && !options.quiet;
  if (options.dry_run) {
    if (ranks.rank() == 0)
      out << textOf (newPlan (options)) << "\n";
    return;
  }
  std::optional<FolderLock> lock;
  if (ranks.rank() == 0) {
    makeFolder (options.output_dir);
    lock.emplace (options.output_dir);
    if (!lock->take())
      throw WorkError (options.output_dir,
                       "another run works in it; wait until it has ended, or give "
                       "another --output-dir");
    preparePlan (options, folder);
    folder.make();
  }
  ranks.meet();
  const Plan plan = loadPlan (planFileOf (folder));
  if (speaks)
    out << textOf (plan) << "\n";
  if (!isDone (plan, folder)) {
    const std::string times =
        TileRun (plan, folder, options, ranks, messages, is_terminal).run();
    if (speaks)
      out << times << "\n";
    if (ranks.rank() == 0) {
      listPlanes (folder);
      writeTextFile (folder.end(), "");
    }
  }
  if (ranks.rank() == 0)
    folder.clean();
  if (ranks.rank() != 0)
    return;
  const std::string planes = saveChosenPlanes (folder.output (planes_file), options);
  if (speaks)
    out << options.output_dir << ": the labelled inputs and planes.json, " << planes
        << "\n";
}

} // namespace pcl_ops::apps
