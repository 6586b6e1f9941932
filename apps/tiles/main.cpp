// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <boost/format.hpp>

#include "phases.h"
#include "planes_json.h"
#include "ranks.h"
#include "survey_warnings.h"
#include <cli/command_line.h>
#include <cli/program.h>
#include <cli/progress.h>
#include <detection/warning_lines.h>
#include <io/inputs.h>
#include <io/output_file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <filesystem>
#include <iostream>
#include <map>
#include <system_error>

namespace fs = std::filesystem;

namespace pcl_ops::apps {

namespace {

constexpr const char* program_name = "pcl_ops_tiles";

struct TilesOptions {
  std::vector<std::string> inputs;
  std::string output_dir;
  PlanOptions plan;
  /** \brief The files of --planes, --image, --view and --floor-plan, and what is about
   * them. */
  PlanesOutput output;
  /** \brief File of the plan of tiles; empty for work/plan.json in the output folder.
   */
  std::string plan_file;
  /** \brief Tiles or inputs processed at a time; 0: one per processor. */
  unsigned jobs = 1;
  bool dry_run = false, quiet = false;
};

constexpr const char* summary =
    R"(Finds the planes of a survey that is larger than the memory, in tiles, and labels
every point with its plane, the same ones for any number of jobs and ranks.)";

constexpr const char* in_and_out =
    R"(  INPUT       tiles in one frame, folders, patterns: .las (.laz by LASzip), which
              are never whole in memory, .pcd, .ply, .ptx, .npy, .bin or text; they
              may overlap
  DIR/NAME    each input with its labels (0: no plane, 1: the largest, ...)
  DIR/planes.json  all planes
  DIR/work    what a run that was stopped goes on from; at the end the plan is left
  mpirun -n 4 pcl_ops_tiles ...  shares the work among processes, all of which see
              the same files
  exit code   0 done; 1 failed; 2 wrong usage
Lengths are in the unit of the inputs, meters by default.
)";

/** \brief Declares the options for files from the list of planes. */
void
declareOutput (CommandLine& line, PlanesOutput& output)
{
  line.add ("planes FILE", output.planes)
      .help ("write planes, all or those to keep: .geojson, .gpkg, .csv, .json");
  line.add ("image FILE.png", output.image)
      .help ("draw the same planes from above, by plane and by orientation");
  line.add ("view FILE.html", output.view)
      .help ("a page that shows the same planes, and points, in a browser");
  line.add ("floor-plan FILE", output.floor_plan)
      .help ("write walls, openings, rooms: .dxf, .svg, .geojson, .gpkg");
  // Chosen by hand, against typing errors.
  const Range heights = from (-1000).upTo (1000);
  line.add ("plan-height M", output.of_floor_plan.cut_height, heights)
      .help ("where --floor-plan cuts the walls, over the lowest floor (1.2)");
}

/** \brief Checks the options for files from the list of planes once all options are
 * read, and completes PlanesOutput::choice. \throws UsageError */
void
finishOutput (const CommandLine& line, PlanesOutput& output)
{
  checkExtension ("--planes", output.planes, {".geojson", ".csv", ".json", ".gpkg"});
  finishChoice (line, output.choice);
  checkMap (line, output.planes, {output.floor_plan});
  if (const std::vector<std::string> given = line.givenOf (title_of_choice);
      !given.empty() && output.files().empty())
    throw UsageError ("--" + given.front(), "is about --planes FILE; give it, too");
  checkExtension ("--image", output.image, {".png"});
  checkExtension ("--view", output.view, {".html"});
  checkExtension (
      "--floor-plan", output.floor_plan, {".dxf", ".svg", ".geojson", ".gpkg"});
  if (line.isGiven ("plan-height") && output.floor_plan.empty())
    throw UsageError ("--plan-height", "is about --floor-plan; give it, too");
}

/** \brief Declares where the outputs go, and how the survey is divided into tiles. */
void
declareTiling (CommandLine& line, TilesOptions& options)
{
  line.add ("output-dir DIR", options.output_dir).help ("where the outputs go");
  // Voxels that single precision can hold, with a margin.
  line.add ("voxel-size M", options.plan.voxel_size, from (1e-30).upTo (1e30))
      .help ("edge of a voxel (by the density: some 20 points in one)")
      .onceCalled ("cell");
  line.add ("tile M", options.plan.tile, above (0))
      .help ("edge of a tile, rounded to 4 voxels (128 voxels; 256 with --voxel-size)");
  line.add ("jobs N", options.jobs, from (0).upTo (256))
      .help ("tiles at a time; 0: one for each processor (1)");
  line.add ("plan FILE", options.plan_file)
      .help ("the plan to follow; written if there is none (DIR/work/plan.json)");
}

/** \return false if it printed --help or --version: nothing is left to do
 * \throws UsageError */
bool
readOptions (int argc, const char* const* argv, TilesOptions& options)
{
  CommandLine line (program_name, summary, PCL_OPS_VERSION);
  line.setUsage ({"INPUT... --output-dir DIR [options]"}, in_and_out);
  line.addArguments ("INPUT", options.inputs, "");
  declareTiling (line, options);
  declareOutput (line, options.output);
  double meter = 1.0;
  declareMeter (line, meter);
  declareMap (line, options.output.map);
  line.add ("dry-run", options.dry_run).help ("print the plan, and do nothing");
  line.add ("quiet", options.quiet).help ("print nothing");
  bool pieces = false;
  line.add ("pieces", pieces).help ("not here: planes.json has parts of planes");
  declareChoice (line, options.output.choice);
  if (!line.parse (argc, argv))
    return false;
  if (line.isGiven ("meter"))
    options.plan.meter = meter;
  if (pieces)
    throw UsageError ("--pieces",
                      "needs all points of a plane at once, which tiles have not; see "
                      "parts in planes.json, or run pcl_ops_segment on one file");
  // In this program --plan is the plan of the tiles, not a floor plan.
  if (hasExtension (options.plan_file, {".dxf", ".svg", ".geojson", ".gpkg"}))
    throw UsageError ("--plan",
                      "is the plan of the tiles here; give --floor-plan " +
                          options.plan_file);
  if (options.output_dir.empty())
    throw UsageError ("--output-dir", "is missing; give a folder for the outputs");
  finishOutput (line, options.output);
  return true;
}

/** \brief Refuses a path that is not UTF-8, as the JSON of the plan and of planes.json
 * cannot hold it. \throws WorkError */
void
checkIsUtf8 (const std::string& file)
{
  const fs::path path = fs::absolute (file).lexically_normal();
  const std::pair<fs::path, const char*> parts[] = {
      {path.filename(), "its name"}, {path, "the name of a folder it is in"}};
  for (const auto& [name, subject] : parts)
    try {
      nlohmann::json (name.string()).dump();
    }
    catch (const nlohmann::json::type_error&) {
      throw WorkError (file, subject + std::string (" is not UTF-8; rename it"));
    }
}

/** \brief Keeps one name of each file: with a second name (a link) its points would
 * count twice. The name of the file is kept rather than that of a symbolic link to it.
 */
std::vector<std::string>
eachFileOnce (std::vector<std::string> names)
{
  std::error_code ignored;
  std::sort (names.begin(), names.end());
  std::stable_partition (names.begin(), names.end(), [&] (const std::string& name) {
    return !fs::is_symlink (name, ignored);
  });
  using FileId = std::pair<dev_t, ino_t>;
  std::map<FileId, std::string> name_of_file;
  std::vector<std::string> files;
  for (const std::string& name : names) {
    struct stat status {};
    const bool is_there = ::stat (name.c_str(), &status) == 0;
    const auto [known, is_new] =
        name_of_file.emplace (FileId (status.st_dev, status.st_ino), name);
    if (is_there && !is_new)
      warn (name + ": is the same file as " + known->second + "; it is left out");
    else
      files.push_back (name);
  }
  return files;
}

/** \brief Returns the files that the options name or match, each once.
 * \throws WorkError if there are none or one has a name that cannot be used */
std::vector<std::string>
inputsOf (const TilesOptions& options)
{
  InputFiles found = findInputs (options.inputs);
  if (!found.problems.empty())
    throw WorkError ("INPUT", found.problems.front());
  for (const std::string& file : found.files)
    checkIsUtf8 (file);
  return eachFileOnce (std::move (found.files));
}

/** \brief By the name of a file the input whose labeled copy is written to it; empty
 * for a file that is an input, a plan or another output. */
using InputOfFile = std::map<std::string, std::string>;

/** \brief Returns the inputs, the plan of the folder, and the file of --plan.
 * \throws UsageError if the file of --plan is an input or planes.json, too */
InputOfFile
inputsAndPlans (const Plan& plan, const RunFolder& folder, const TilesOptions& options)
{
  InputOfFile files;
  for (const PlannedInput& input : plan.inputs)
    files.emplace (resolvedName (input.file), "");
  const std::string own_plan = resolvedName (folder.work (run_file::plan));
  files.emplace (own_plan, "");
  if (options.plan_file.empty())
    return files;
  const std::string name = resolvedName (options.plan_file);
  const bool is_new = files.emplace (name, "").second;
  if ((!is_new && name != own_plan) ||
      name == resolvedName (folder.output (planes_file)))
    throw UsageError (options.plan_file,
                      "is an input or another output; give another --plan");
  return files;
}

/** \brief Refuses outputs that would be written over each other or over an input.
 * \throws UsageError, or WorkError as \ref checkWritable */
void
checkClashes (const Plan& plan, const RunFolder& folder, const TilesOptions& options)
{
  InputOfFile input_of_file = inputsAndPlans (plan, folder, options);
  checkWritable (folder.output (planes_file));
  for (std::size_t i = 0; i < plan.inputs.size(); ++i) {
    const std::string output = outputOf (plan, folder, i);
    const std::string& input = plan.inputs[i].file;
    const auto [known, is_new] = input_of_file.emplace (resolvedName (output), input);
    const std::string& first_input = known->second;
    if (!is_new && first_input.empty())
      throw UsageError (output,
                        "is an input or the plan, too; give another --output-dir");
    if (!is_new)
      throw UsageError (first_input + " and " + input,
                        "would both be written to " + output + "; rename one");
    checkWritable (output);
  }
  input_of_file.emplace (resolvedName (folder.output (planes_file)), "");
  for (const RequestedFile& file : options.output.files()) {
    const bool is_new = input_of_file.emplace (resolvedName (file.name), "").second;
    if (!is_new)
      throw UsageError (file.name,
                        "is an input or another output; give another " + file.option);
    checkWritable (file.name);
  }
}

/** \brief Returns the line that --dry-run prints. */
std::string
summaryOf (const Plan& plan)
{
  const std::size_t inputs = plan.inputs.size();
  return str (
      boost::format ("%d points of %d input%s, voxels of %g, about %d tile%s of %g") %
      plan.points() % inputs % (inputs == 1 ? "" : "s") % plan.grid.edge %
      plan.likely_tiles % (plan.likely_tiles == 1 ? "" : "s") % plan.grid.edgeOfTile());
}

/** \brief Runs the phases of a plan: of each phase the parts (inputs or tiles) that are
 * this rank's share. */
struct TileRun {
  const Plan& plan;
  const RunFolder& folder;
  const TilesOptions& options;
  const Ranks& ranks;
  /** \brief When the phase began. */
  std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
  /** \brief \ref processorTime when the phase began [s]. */
  double processor_start = processorTime();
  /** \brief How long each finished phase took, in words. */
  std::string times = {};

  /** \brief Processor time of this rank over all of its threads [s]. */
  static double
  processorTime ()
  {
    return static_cast<double> (std::clock()) / CLOCKS_PER_SEC;
  }

  /** \return \ref times */
  std::string
  run ()
  {
    const bool is_first = ranks.rank == 0;
    const auto is_sorted = [&] (std::size_t input) {
      return isThere (folder.blocks (input));
    };
    runInputs ("sorted", is_sorted, partitionInput);
    const SortedPoints points (plan, folder);
    if (is_first && !isThere (folder.work (run_file::noise)))
      inMemory ("--tile", "give a smaller one", [&] {
        measureSurvey (plan, folder, points);
      });
    endPhase ("noise measured");
    runTiles (points);
    endPhase ("planes found");
    if (is_first && !isThere (folder.work (run_file::list)))
      joinTiles (plan, folder, points);
    endPhase ("joined");
    const auto is_labeled = [&] (std::size_t input) {
      return isThere (folder.labeledMark (input)) &&
             isThere (outputOf (plan, folder, input));
    };
    runInputs ("labelled", is_labeled, labelInput);
    return times;
  }

private:
  using IsDone = std::function<bool (std::size_t)>;
  using PhaseOfInput = void (const Plan&, const RunFolder&, std::size_t input);

  /** \brief Runs a phase for this rank's share of the inputs.
   * \param[in] name of the phase for \ref times and the progress bar */
  void
  runInputs (const std::string& name, const IsDone& is_done, PhaseOfInput* phase)
  {
    std::vector<std::uint64_t> points_of_input;
    for (const PlannedInput& input : plan.inputs)
      points_of_input.push_back (input.points);
    runParts (points_of_input, "inputs " + name, is_done, [&] (std::size_t input) {
      inMemory (plan.inputs[input].file, "give fewer --jobs", [&] {
        phase (plan, folder, input);
      });
    });
    endPhase (name);
  }

  /** \brief Finds the planes in this rank's share of the tiles. */
  void
  runTiles (const SortedPoints& points)
  {
    const auto is_found = [&] (std::size_t i) {
      return isThere (folder.ofTile (points.tiles[i], ".planes"));
    };
    runParts (points.points_of_tile, "tiles", is_found, [&] (std::size_t i) {
      inMemory ("--tile", "give a smaller one or fewer --jobs", [&] {
        detectTile (plan, folder, points, points.tiles[i]);
      });
    });
  }

  /** \brief Waits until all ranks have finished a phase, and notes its time. */
  void
  endPhase (const std::string& phase)
  {
    ranks.meet();
    const auto now = std::chrono::steady_clock::now();
    const double processor = processorTime();
    times += str (boost::format ("%s%s in %.1f s (%.1f of the processor)") %
                  (times.empty() ? "" : ", ") % phase %
                  std::chrono::duration<double> (now - start).count() %
                  (processor - processor_start));
    start = now;
    processor_start = processor;
  }

  /** \brief Runs a phase for this rank's share of the parts, except for parts that an
   * earlier run has done.
   * \param[in] points_of_part number of points of each part: the amount of work
   * \param[in] noun what the progress bar counts
   * \param[in] is_done whether a part was done before, by its position
   * \param[in] run_part runs the phase for a part, by its position */
  void
  runParts (const std::vector<std::uint64_t>& points_of_part,
            const std::string& noun,
            const IsDone& is_done,
            const std::function<void (std::size_t)>& run_part)
  {
    std::vector<std::size_t> parts = shareOf (ranks.rank, ranks.size, points_of_part);
    parts.erase (std::remove_if (parts.begin(), parts.end(), is_done), parts.end());
    const bool is_terminal = ::isatty (STDERR_FILENO) == 1;
    const bool shows_progress = ranks.rank == 0 && !options.quiet;
    Progress progress (parts.size(),
                       std::cerr,
                       shows_progress ? progressStyleOf (is_terminal)
                                      : ProgressStyle::None,
                       noun);
    runInParallel (parts.size(), options.jobs, [&] (std::size_t i) {
      stopIfInterrupted();
      run_part (parts[i]);
      progress.step();
    });
  }
};

/** \brief Whether a run has finished and all its outputs still exist. */
bool
isDone (const Plan& plan, const RunFolder& folder)
{
  for (std::size_t i = 0; i < plan.inputs.size(); ++i)
    if (!isThere (outputOf (plan, folder, i)))
      return false;
  return isThere (folder.work (run_file::end_mark)) &&
         isThere (folder.output (planes_file));
}

PlanFile
planFileOf (const RunFolder& folder)
{
  return {folder.work (run_file::plan),
          "remove its folder or give another --output-dir"};
}

/** \brief Makes sure that a folder has a plan: its own, that of --plan, or a new one.
 * If the folder has no plan, files that an earlier run left in it are removed first. A
 * missing file of --plan is written, too.
 * \throws UsageError or WorkError if a plan does not fit this run, the folder has
 * another plan than --plan, or outputs cannot be written */
void
preparePlan (const TilesOptions& options, const RunFolder& folder)
{
  const PlanFile own = planFileOf (folder);
  const PlanFile named = // by --plan; the same file without it
      options.plan_file.empty() ? own
                                : PlanFile{options.plan_file, "give another --plan"};
  const bool has_own = isThere (own.name);
  const auto load_for_this_run = [&] (const PlanFile& file) {
    Plan plan = loadPlan (file);
    checkIsFor (plan, file, inputsOf (options), options.plan);
    return plan;
  };
  const Plan plan = isThere (named.name) ? load_for_this_run (named)
                    : has_own            ? load_for_this_run (own)
                                         : makePlan (inputsOf (options), options.plan);
  if (has_own && toText (loadPlan (own)) != toText (plan))
    throw WorkError (own.name, "is another plan than " + named.name + "; " + own.fix);
  checkClashes (plan, folder, options);
  if (!has_own)
    folder.removeEarlierRun();
  folder.makeFolders();
  for (const PlanFile& file : {named, own})
    if (!isThere (file.name))
      writeTextFile (file.name, toText (plan));
}

/** \brief Returns the options with the unit of the plan and, if none is given, the
 * reference system of its inputs. */
PlanesOutput
withUnitAndCrsOf (const Plan& plan, PlanesOutput output)
{
  output.of_floor_plan.meter = plan.meter;
  if (output.map.crs.empty())
    output.map.crs = commonCrs (plan);
  return output;
}

/** \brief Prints times and numbers of planes to stdout; contents of files, and
 * warnings, to stderr. */
void
printResult (const std::string& folder,
             const std::string& times,
             const PlaneMessages& messages)
{
  std::cout << times << folder << ": the labelled inputs and planes.json, "
            << messages.counts << "\n"
            << std::flush;
  for (const std::string& line : messages.file_notes)
    warn (line);
  WarningLines warnings;
  warnings.add (folder, messages.warnings);
  for (const std::string& line : warnings.lines())
    warn (line);
}

/** \brief Creates a folder if it is missing, and locks it.
 * \throws WorkError if another run has locked it */
void
lockFolder (const std::string& folder, std::optional<FolderLock>& lock)
{
  makeFolder (folder);
  if (!lock.emplace (folder).take())
    throw WorkError (folder,
                     "another run works in it; wait until it has ended, or give "
                     "another --output-dir");
}

/** \brief Writes planes.json, unless an earlier run has, then removes the files of the
 * phases, and then writes the files that the options name. A run that stops among these
 * counts as finished.
 * \throws WorkError if the list of planes is damaged or a file cannot be written */
PlaneMessages
finishRun (const Plan& plan,
           const RunFolder& folder,
           const TilesOptions& options,
           bool is_done)
{
  const auto for_each_point = [&] (const VisitLabeledPosition& visit) {
    forEachLabeledPoint (plan, folder, visit);
  };
  if (!is_done)
    folder.finish ([&] (const std::string& list) {
      return withWarnings (plan, options.plan.meter.has_value(), list, for_each_point);
    });
  folder.removePhaseFiles(); // those that cannot be removed do no harm
  return saveChosenPlanes (folder.output (planes_file),
                           for_each_point,
                           withUnitAndCrsOf (plan, options.output));
}

/** \brief Runs the program together with all other ranks. Each part of a phase ends
 * with a file; a later run leaves out the parts whose files exist.
 * \return exit code */
int
findInTiles (int argc, const char* const* argv, const Ranks& ranks)
{
  TilesOptions options;
  if (!readOptions (argc, argv, options))
    return ExitCode::done;
  const RunFolder folder{options.output_dir};
  const bool is_first = ranks.rank == 0;
  const bool prints = is_first && !options.quiet;
  if (options.dry_run) {
    if (is_first)
      std::cout << summaryOf (makePlan (inputsOf (options), options.plan)) << "\n";
    return ExitCode::done;
  }
  std::optional<FolderLock> lock;
  if (is_first) {
    lockFolder (options.output_dir, lock);
    preparePlan (options, folder);
  }
  ranks.meet();
  const Plan plan = loadPlan (planFileOf (folder));
  const bool is_done = isDone (plan, folder);
  if (prints)
    std::cout << summaryOf (plan) << "\n";
  const std::string times =
      is_done ? "" : TileRun{plan, folder, options, ranks}.run() + "\n";
  if (!is_first)
    return ExitCode::done;
  const PlaneMessages messages = finishRun (plan, folder, options, is_done);
  if (prints)
    printResult (options.output_dir, times, messages);
  return ExitCode::done;
}

} // namespace

} // namespace pcl_ops::apps

int
main (int argc, char** argv)
{
  using namespace pcl_ops::apps;
  noteInterruptions();
  const Ranks ranks;
  const int code = runProgram (program_name, [&] {
    return asResumable ([&] { return findInTiles (argc, argv, ranks); });
  });
  if (code != ExitCode::done) {
    ranks.endAll (code);
    endAsInterrupted();
  }
  return code;
}
