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
  PlanesOutput planes;
  /** \brief File of the plan; empty for work/plan.json in the output folder. */
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

void
checkPlanes (const CommandLine& line, PlanesOutput& planes)
{
  checkExtension ("--planes", planes.file, {".geojson", ".csv", ".json", ".gpkg"});
  finishChoice (line, planes.choice);
  checkMap (line, planes.file, {planes.floor_plan});
  if (const auto given = line.givenOf (title_of_choice);
      !given.empty() && planes.files().empty())
    throw UsageError ("--" + given.front(), "is about --planes FILE; give it, too");
  checkExtension ("--image", planes.image, {".png"});
  checkExtension ("--view", planes.view, {".html"});
  checkExtension (
      "--floor-plan", planes.floor_plan, {".dxf", ".svg", ".geojson", ".gpkg"});
  if (line.isGiven ("plan-height") && planes.floor_plan.empty())
    throw UsageError ("--plan-height", "is about --floor-plan; give it, too");
}

/** \brief \return false if --help or --version was answered and nothing is left to do
 * \throws UsageError */
bool
readOptions (int argc, const char* const* argv, TilesOptions& options)
{
  CommandLine line (program_name, summary, PCL_OPS_VERSION);
  line.setUsage ({"INPUT... --output-dir DIR [options]"}, in_and_out);
  line.addArguments ("INPUT", options.inputs, "");
  line.add ("output-dir DIR", options.output_dir).help ("where the outputs go");
  line.add ("voxel-size M", options.plan.voxel_size, above (0))
      .help ("edge of a voxel (by the density: some 20 points in one)")
      .onceCalled ("cell");
  line.add ("tile M", options.plan.tile, above (0))
      .help ("edge of a tile, rounded to 4 voxels (128 voxels; 256 with --voxel-size)");
  line.add ("jobs N", options.jobs, from (0).upTo (256))
      .help ("tiles at a time; 0: one for each processor (1)");
  line.add ("plan FILE", options.plan_file)
      .help ("the plan to follow; written if there is none (DIR/work/plan.json)");
  line.add ("planes FILE", options.planes.file)
      .help ("write planes, all or those to keep: .geojson, .gpkg, .csv, .json");
  line.add ("image FILE.png", options.planes.image)
      .help ("draw the same planes from above, by plane and by orientation");
  line.add ("view FILE.html", options.planes.view)
      .help ("a page that shows the same planes, and points, in a browser");
  line.add ("floor-plan FILE", options.planes.floor_plan)
      .help ("write walls, openings, rooms: .dxf, .svg, .geojson, .gpkg");
  line.add (
          "plan-height M", options.planes.of_plan.cut_height, from (-1000).upTo (1000))
      .help ("where --floor-plan cuts the walls, over the lowest floor (1.2)");
  double meter = 1.0;
  declareMeter (line, meter);
  declareMap (line, options.planes.map);
  line.add ("dry-run", options.dry_run).help ("print the plan, and do nothing");
  line.add ("quiet", options.quiet).help ("print nothing");
  bool pieces = false;
  line.add ("pieces", pieces).help ("not here: planes.json has parts of planes");
  declareChoice (line, options.planes.choice);
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
  checkPlanes (line, options.planes);
  return true;
}

/** \brief Refuses a path that is not UTF-8, as the JSON of the plan and of planes.json
 * cannot hold it. \throws WorkError */
void
checkName (const std::string& file)
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

/** \brief Keeps one name of each file, as its points would count twice through a second
 * name (a link). A file goes before symbolic links to it, whatever the names. */
std::vector<std::string>
eachFileOnce (std::vector<std::string> names)
{
  std::error_code ignored;
  std::sort (names.begin(), names.end());
  std::stable_partition (names.begin(), names.end(), [&] (const std::string& name) {
    return !fs::is_symlink (name, ignored);
  });
  std::map<std::pair<dev_t, ino_t>, std::string> seen;
  std::vector<std::string> files;
  for (const std::string& name : names) {
    struct stat status {};
    const bool is_there = ::stat (name.c_str(), &status) == 0;
    const auto [known, is_new] =
        seen.emplace (std::pair (status.st_dev, status.st_ino), name);
    if (is_there && !is_new)
      warn (name + ": is the same file as " + known->second + "; it is left out");
    else
      files.push_back (name);
  }
  return files;
}

std::vector<std::string>
inputsOf (const TilesOptions& options)
{
  InputFiles found = findInputs (options.inputs);
  if (!found.problems.empty())
    throw WorkError ("INPUT", found.problems.front());
  for (const std::string& file : found.files)
    checkName (file);
  return eachFileOnce (std::move (found.files));
}

/** \brief Refuses outputs that would be written over each other or over an input. */
void
checkClashes (const Plan& plan, const RunFolder& folder, const TilesOptions& options)
{
  // Key: name of a file. Value: the input written to it, or empty for other files.
  std::map<std::string, std::string> input_of;
  for (const PlannedInput& input : plan.inputs)
    input_of.emplace (resolvedName (input.file), "");
  checkWritable (folder.output (planes_file));
  for (std::size_t i = 0; i < plan.inputs.size(); ++i) {
    const std::string output = outputOf (plan, folder, i);
    const std::string& input = plan.inputs[i].file;
    const auto [first, is_new] = input_of.emplace (resolvedName (output), input);
    if (!is_new && first->second.empty())
      throw UsageError (output, "is an input, too; give another --output-dir");
    if (!is_new)
      throw UsageError (first->second + " and " + input,
                        "would both be written to " + output + "; rename one");
    checkWritable (output);
  }
  input_of.emplace (resolvedName (folder.output (planes_file)), "");
  const auto check_output = [&] (const std::string& option, const std::string& file) {
    if (!input_of.emplace (resolvedName (file), "").second)
      throw UsageError (file, "is an input or another output; give another " + option);
    checkWritable (file);
  };
  for (const auto& [option, file] : options.planes.files())
    check_output (option, file);
}

std::string
textOf (const Plan& plan)
{
  const std::size_t inputs = plan.inputs.size();
  return str (
      boost::format ("%d points of %d input%s, voxels of %g, about %d tile%s of %g") %
      plan.points() % inputs % (inputs == 1 ? "" : "s") % plan.grid.edge %
      plan.likely_tiles % (plan.likely_tiles == 1 ? "" : "s") % plan.grid.edgeOfTile());
}

struct TileRun {
  const Plan& plan;
  const RunFolder& folder;
  const TilesOptions& options;
  const Ranks& ranks;
  std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
  double processor_start = static_cast<double> (std::clock()) / CLOCKS_PER_SEC;
  std::string times = {};

  /** \return how long each phase took, in words */
  std::string
  run ()
  {
    std::vector<std::uint64_t> points_of_input;
    for (const PlannedInput& input : plan.inputs)
      points_of_input.push_back (input.points);
    const auto share_inputs =
        [&] (const std::string& phase, const auto& is_done, const auto& work) {
          share (points_of_input, "inputs " + phase, is_done, [&] (std::size_t i) {
            inMemory (plan.inputs[i].file, "give fewer --jobs", [&] {
              work (plan, folder, i);
            });
          });
          finish (phase);
        };
    const auto is_sorted = [&] (std::size_t i) { return isThere (folder.cells (i)); };
    share_inputs ("sorted", is_sorted, partitionInput);
    const SortedPoints points (plan, folder);
    if (ranks.rank == 0 && !isThere (folder.work (run_file::noise)))
      inMemory ("--tile", "give a smaller one", [&] {
        measureSurvey (plan, folder, points);
      });
    finish ("noise measured");
    const auto is_found = [&] (std::size_t i) {
      return isThere (folder.ofTile (points.tiles[i], ".planes"));
    };
    share (points.points_of_tile, "tiles", is_found, [&] (std::size_t i) {
      inMemory ("--tile", "give a smaller one or fewer --jobs", [&] {
        detectTile (plan, folder, points, points.tiles[i]);
      });
    });
    finish ("planes found");
    if (ranks.rank == 0 && !isThere (folder.work (run_file::list)))
      joinTiles (plan, folder, points);
    finish ("joined");
    const auto is_labelled = [&] (std::size_t i) {
      return isThere (folder.mark (i)) && isThere (outputOf (plan, folder, i));
    };
    share_inputs ("labelled", is_labelled, labelInput);
    return times;
  }

  /** \brief Waits until all ranks have finished a phase, and notes its time. */
  void
  finish (const std::string& phase)
  {
    ranks.meet();
    const auto now = std::chrono::steady_clock::now();
    // CPU time of this rank, over all of its threads.
    const double processor = static_cast<double> (std::clock()) / CLOCKS_PER_SEC;
    times += str (boost::format ("%s%s in %.1f s (%.1f of the processor)") %
                  (times.empty() ? "" : ", ") % phase %
                  std::chrono::duration<double> (now - start).count() %
                  (processor - processor_start));
    start = now;
    processor_start = processor;
  }

  /** \brief Does this rank's share of a phase, without the parts done before.
   * \param[in] parts amount of work of each part */
  void
  share (const std::vector<std::uint64_t>& parts,
         const std::string& noun,
         const std::function<bool (std::size_t)>& is_done,
         const std::function<void (std::size_t)>& work)
  {
    std::vector<std::size_t> own = shareOf (ranks.rank, ranks.size, parts);
    own.erase (std::remove_if (own.begin(), own.end(), is_done), own.end());
    const bool is_terminal = ::isatty (STDERR_FILENO) == 1;
    Progress progress (own.size(),
                       std::cerr,
                       ranks.rank == 0 && !options.quiet ? progressStyleOf (is_terminal)
                                                         : ProgressStyle::None,
                       noun);
    try {
      runInParallel (own.size(), options.jobs, [&] (std::size_t i) {
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
};

/** \brief Whether a run has finished and all its outputs still exist. */
bool
isDone (const Plan& plan, const RunFolder& folder)
{
  for (std::size_t i = 0; i < plan.inputs.size(); ++i)
    if (!isThere (outputOf (plan, folder, i)))
      return false;
  return isThere (folder.work (run_file::end)) && isThere (folder.output (planes_file));
}

PlanFile
planFileOf (const RunFolder& folder)
{
  return {folder.work (run_file::plan),
          "remove its folder or give another --output-dir"};
}

/** \brief Makes sure that a folder has a plan: its own, that of --plan, or a new one. A
 * folder without a plan first loses what an earlier run left.
 * \throws UsageError or WorkError if a plan does not fit this run, the folder has
 * another plan than --plan, or outputs cannot be written */
void
preparePlan (const TilesOptions& options, const RunFolder& folder)
{
  const PlanFile own = planFileOf (folder);
  const PlanFile named =
      options.plan_file.empty()
          ? own
          : PlanFile{options.plan_file, "remove it or give another --plan"};
  const bool has_own = isThere (own.name);
  const auto earlier = [&] (const PlanFile& file) {
    Plan plan = loadPlan (file);
    checkIsFor (plan, file, inputsOf (options), options.plan);
    return plan;
  };
  const Plan plan = isThere (named.name) ? earlier (named)
                    : has_own            ? earlier (own)
                                         : makePlan (inputsOf (options), options.plan);
  if (has_own && toText (loadPlan (own)) != toText (plan))
    throw WorkError (own.name, "is another plan than " + named.name + "; " + own.fix);
  checkClashes (plan, folder, options);
  if (!has_own)
    folder.empty();
  folder.make();
  for (const PlanFile& file : {named, own})
    if (!isThere (file.name))
      writeTextFile (file.name, toText (plan));
}

/** \brief Adds to the options the unit of the plan and, if none is given, the reference
 * system of its inputs. */
PlanesOutput
outputIn (const Plan& plan, PlanesOutput output)
{
  output.of_plan.meter = plan.meter;
  if (output.map.crs.empty())
    output.map.crs = commonCrs (plan);
  return output;
}

/** \brief Prints times and counts to stdout; what a floor plan has, and warnings, to
 * stderr. */
void
say (const std::string& folder, const std::string& times, const PlanesSaid& planes)
{
  std::cout << times << folder << ": the labelled inputs and planes.json, "
            << planes.counts << "\n"
            << std::flush;
  for (const std::string& line : planes.written)
    warn (line);
  WarningLines doubts;
  doubts.add (folder, planes.warnings);
  for (const std::string& line : doubts.lines())
    warn (line);
}

/** \brief Runs the program together with all other ranks. Each phase leaves files; a
 * later run skips the parts whose files exist.
 * \return exit code */
int
findInTiles (int argc, const char* const* argv, const Ranks& ranks)
{
  TilesOptions options;
  if (!readOptions (argc, argv, options))
    return ExitCode::done;
  const RunFolder folder{options.output_dir};
  const bool is_first = ranks.rank == 0;
  const bool speaks = is_first && !options.quiet;
  if (options.dry_run) {
    if (is_first)
      std::cout << textOf (makePlan (inputsOf (options), options.plan)) << "\n";
    return ExitCode::done;
  }
  std::optional<FolderLock> lock;
  if (is_first) {
    makeFolder (options.output_dir);
    if (!lock.emplace (options.output_dir).take())
      throw WorkError (options.output_dir,
                       "another run works in it; wait until it has ended, or give "
                       "another --output-dir");
    preparePlan (options, folder);
  }
  ranks.meet();
  const Plan plan = loadPlan (planFileOf (folder));
  const bool is_done = isDone (plan, folder);
  if (speaks)
    std::cout << textOf (plan) << "\n";
  const std::string times =
      is_done ? "" : TileRun{plan, folder, options, ranks}.run() + "\n";
  if (!is_first)
    return ExitCode::done;
  const auto points = [&] (const VisitLabelled& visit) {
    forLabelledPoints (plan, folder, visit);
  };
  if (!is_done)
    folder.finish ([&] (const std::string& list) {
      return withWarnings (plan, options.plan.meter.has_value(), list, points);
    });
  folder.clean();
  const PlanesSaid planes = saveChosenPlanes (
      folder.output (planes_file), points, outputIn (plan, options.planes));
  if (speaks)
    say (options.output_dir, times, planes);
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
  const int code =
      runProgram (program_name, [&] { return findInTiles (argc, argv, ranks); });
  if (code != ExitCode::done) {
    ranks.endAll (code);
    endAsInterrupted();
  }
  return code;
}
