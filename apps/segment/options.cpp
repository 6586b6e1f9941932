// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "options.h"

#include <boost/algorithm/string/replace.hpp>

#include "report.h"
#include "stages.h"
#include <cli/command_line.h>
#include <cli/errors.h>
#include <io/inputs.h>
#include <io/las_file.h>
#include <io/output_file.h>
#include <numbers/angles.h>

#include <filesystem>
#include <map>

namespace fs = std::filesystem;

namespace pcl_ops::apps {

namespace {

constexpr const char* summary =
    "Finds the planes of point clouds and labels every point with its plane.";

/** \brief Stands for the name of the input in the names of outputs of a batch. */
constexpr const char* name_placeholder = "{}";

constexpr const char* help_on_arguments =
    "  INPUT       .pcd, .ply, .las (.laz by LASzip), .ptx, .npy, .bin, text; - for\n"
    "              one piped in; with --output-dir several, folders, 'scans/*.pcd'\n"
    "  OUTPUT.pcd  the cloud with label (0: no plane, 1: the largest, ...) and rgb;\n"
    "              .ply the same; .las of a .las: all as it was, and the label, too\n"
    "  prints      a table; with INPUT - JSON; with --output-dir a line per INPUT\n"
    "  no plane    is no failure: all labels 0, and a hint which option to change\n"
    "  exit code   0 done; 1 failed, with --output-dir any input; 2 wrong usage\n"
    "Lengths are in the unit of the cloud, meters by default; angles in degrees.\n";

/** \brief An option that names an output. */
struct OutputOption {
  /** \brief Without "--". */
  std::string name;
  std::string Outputs::*output;
  /** \brief Allowed extensions of the file; empty for a folder. */
  std::vector<std::string> extensions;
};

/** \brief All outputs except the labeled cloud (OUTPUT): \ref checkOutputs has its
 * extensions, as LAZ depends on the build. */
const OutputOption output_options[] = {
    {"planes", &Outputs::planes, {".json", ".csv", ".geojson", ".gpkg"}},
    {"image", &Outputs::image, {".png"}},
    {"view", &Outputs::view, {".html"}},
    {"mesh", &Outputs::mesh, {".ply", ".vtk", ".obj"}},
    {"edges", &Outputs::edges, {".ply", ".vtk", ".json", ".dxf", ".geojson", ".gpkg"}},
    {"floor-plan", &Outputs::floor_plan, {".dxf", ".svg", ".geojson", ".gpkg"}},
    {"rest", &Outputs::rest, {".pcd", ".ply"}},
    {"planes-dir", &Outputs::planes_dir, {}},
    {"trace", &Outputs::trace, {}}};

void
declareOutputs (CommandLine& line, SegmentOptions& options)
{
  Outputs& outputs = options.outputs;
  line.add ("output-dir DIR", options.output_dir)
      .help ("write DIR/NAME.pcd, .json for each INPUT NAME.pcd;\n"
             "outputs below are in it, with {} for NAME");
  constexpr double max_jobs = 256; // chosen by hand, against typing errors
  line.add ("jobs N", options.jobs, from (0).upTo (max_jobs))
      .help ("INPUTs at a time; 0: one for each processor (1)");
  line.add ("planes FILE", outputs.planes)
      .help ("write planes: .json, .csv, .geojson, .gpkg; -: print");
  line.add ("image FILE.png", outputs.image).help ("write a picture of the planes");
  line.add ("view FILE.html", outputs.view)
      .help ("write a page to look at them in a browser");
  line.add ("hull", options.hull, {"convex", "concave"})
      .help ("outline of a plane in --planes, --view (convex)");
  line.add ("pieces", options.divides_into_pieces)
      .help ("each connected piece of a plane has a label of its own");
  line.add ("quiet", options.quiet).help ("print no table");
}

void
declareFurtherOutputs (CommandLine& line, SegmentOptions& options)
{
  Outputs& outputs = options.outputs;
  line.beginGroup ("Further outputs");
  declareMap (line, options.map);
  declareMeter (line, options.plan_parameters.meter);
  line.add ("keep-color", options.keeps_color).help ("keep the input's rgb in OUTPUT");
  line.add ("distances", options.has_distances)
      .help ("add each point's signed distance to its plane");
  line.add ("piece-gap R", options.piece_parameters.max_gap, from (1))
      .help ("widest gap in one of --pieces, in spacings of its points (8)");
  line.add ("regularize", options.regularizes)
      .help ("make nearly parallel, orthogonal and coplanar planes exactly so");
  line.add ("mesh FILE", outputs.mesh)
      .help ("write the hulls as a mesh: .ply, .vtk or .obj");
  line.add ("edges FILE", outputs.edges)
      .help ("write where planes meet: .ply, .vtk, .dxf, .json, .geojson, .gpkg");
  line.add ("floor-plan FILE", outputs.floor_plan)
      .help ("write a floor plan: .dxf, .svg, .geojson, .gpkg (also --plan)")
      .onceCalled ("plan");
  // Chosen by hand, against typing errors.
  const Range heights = from (-1000).upTo (1000);
  line.add ("plan-height M", options.plan_parameters.cut_height, heights)
      .help ("where --floor-plan cuts the walls, over the lowest floor (1.2)");
  line.add ("rest FILE", outputs.rest)
      .help ("write the points on no plane: .pcd or .ply");
  line.add ("planes-dir DIR", outputs.planes_dir)
      .help ("write each plane: plane_001_horizontal.pcd, ...");
  line.add ("format", options.format, {"pcd", "ply"})
      .help ("of clouds in --output-dir and --planes-dir (pcd)");
  line.add ("trace DIR", outputs.trace)
      .help ("write what each stage made: 1_density.pcd, .png, ...");
}

void
declareTracking (CommandLine& line, TrackOptions& options)
{
  line.beginGroup ("Clouds in sequence, with --output-dir");
  line.add ("track", options.is_on)
      .help ("label and id of a plane are the same in all INPUTs");
  line.add ("poses FILE", options.poses_file)
      .help ("where the sensor was: a line \"timestamp tx ty tz qx qy qz qw\" or the "
             "12 numbers of KITTI for each INPUT (it hardly moves)");
  line.add ("calib FILE", options.calibration_file)
      .help ("KITTI's calib.txt, as its poses are those of a camera");
  line.add ("rotation-error DEG",
            [&options] (const std::string& text) {
              options.matching.rotation_error = toRadians (
                  parseNumber<double> ("--rotation-error", text, from (0).upTo (90)));
            })
      .help ("how far a turn from INPUT to INPUT is off (3)");
  line.add ("translation-error M", options.matching.translation_error, from (0))
      .help ("how far a move from INPUT to INPUT is off (0.05)");
}

/** \brief Stores the arguments: INPUT and, if given, OUTPUT; with --output-dir all are
 * inputs. */
void
storeArguments (const std::vector<std::string>& arguments, SegmentOptions& options)
{
  options.inputs = arguments;
  if (options.isBatch())
    return;
  if (arguments[0] != standard_stream)
    checkIsOneCloud (arguments[0]);
  if (arguments.size() > 2)
    throw UsageError (
        arguments[2],
        "is one argument too many; for several clouds give --output-dir DIR, too");
  if (arguments.size() == 2) {
    options.outputs.cloud = arguments[1];
    options.inputs.pop_back();
  }
  if (options.inputs[0] == standard_stream && options.outputs.planes.empty())
    options.outputs.planes = standard_stream;
}

/** \brief An option that has an effect only together with others. */
struct DependentOption {
  std::string name;
  /** \brief Whether one of the others is given. */
  bool has_effect;
  /** \brief End of the message: the other options, and what the user can do. */
  std::string others_and_fix;
};

/** \brief Throws UsageError for options that have no effect without other options. */
void
checkHaveEffect (const CommandLine& line, const SegmentOptions& options)
{
  const Outputs& outputs = options.outputs;
  const bool is_batch = options.isBatch();
  const bool is_tracked = options.track.is_on;
  const bool has_cloud = is_batch || !outputs.cloud.empty();
  const auto is_given = [&line] (const char* name) { return line.isGiven (name); };
  const char* const filters_by_hull[] = {
      "min-area", "max-area", "min-width", "max-width", "size"};
  const bool has_hulls =
      is_batch || !outputs.planes.empty() || !outputs.mesh.empty() ||
      !outputs.view.empty() ||
      std::any_of (std::begin (filters_by_hull), std::end (filters_by_hull), is_given);
  const DependentOption dependent_options[] = {
      {"hull", has_hulls, "--planes, --view, --mesh and filters by size; give one"},
      {"piece-gap", options.divides_into_pieces, "--pieces; give it, too"},
      {"plan-height", !outputs.floor_plan.empty(), "--floor-plan; give it, too"},
      {"poses", is_tracked, "--track; give it, too"},
      {"calib", !options.track.poses_file.empty(), "--poses; give it, too"},
      {"rotation-error", is_tracked, "--track; give it, too"},
      {"translation-error", is_tracked, "--track; give it, too"},
      {"track", is_batch, "several inputs; give --output-dir, too"},
      {"jobs", is_batch, "several inputs; give --output-dir, too"},
      {"keep-color", has_cloud, "OUTPUT.pcd; give one"},
      {"distances", has_cloud, "OUTPUT; give one"},
      {"trace",
       hasStages (methodCalled (options.method), options.detector),
       "the default engine, as others have no stages; leave out --method, --preset and "
       "--voxel-size"},
      {"format",
       is_batch || !outputs.planes_dir.empty(),
       "--output-dir and --planes-dir; give one, or name OUTPUT and --rest by their "
       "extension"}};
  for (const DependentOption& option : dependent_options)
    if (line.isGiven (option.name) && !option.has_effect)
      throw UsageError ("--" + option.name, "is about " + option.others_and_fix);
}

/** \brief Throws UsageError for outputs with unknown extensions, and for --quiet
 * without an output. */
void
checkOutputs (const SegmentOptions& options)
{
  const Outputs& outputs = options.outputs;
  std::vector<std::string> cloud_extensions = {".pcd", ".ply", ".las"};
  if (hasLaszip())
    cloud_extensions.emplace_back (".laz");
  checkExtension ("OUTPUT", outputs.cloud, cloud_extensions);
  for (const OutputOption& option : output_options) {
    const bool is_printed =
        option.output == &Outputs::planes && outputs.planes == standard_stream;
    if (!option.extensions.empty() && !is_printed)
      checkExtension ("--" + option.name, outputs.*option.output, option.extensions);
  }
  const bool has_output = options.isBatch() || !outputs.planes.empty() ||
                          !outputs.files().empty() || !outputs.planes_dir.empty();
  if (options.quiet && !has_output)
    throw UsageError (
        "--quiet",
        "leaves nothing to do; give OUTPUT.pcd, --planes or another output, too");
}

/** \brief Throws UsageError for an output that every input of a batch would write, and
 * for the standard input in a batch. */
void
checkBatch (const SegmentOptions& options)
{
  for (const std::string& input : options.inputs)
    if (input == standard_stream)
      throw UsageError (standard_stream,
                        "is one cloud without a name; leave out --output-dir");
  if (options.outputs.planes == standard_stream)
    throw UsageError ("--planes",
                      "- prints the planes of one input; leave it out, as each input "
                      "gets a NAME.json");
  for (const OutputOption& option : output_options) {
    const std::string& pattern = options.outputs.*option.output;
    if (!pattern.empty() && pattern.find (name_placeholder) == std::string::npos)
      throw UsageError ("--" + option.name,
                        pattern +
                            " would be written by every input; put {} where the "
                            "name of the input goes, as in {}_" +
                            fs::path (pattern).filename().string());
  }
}

/** \brief A file or folder that a task writes. */
struct TaskOutput {
  /** \brief Name in messages, relative or absolute as in Task::outputs. */
  std::string name;
  const Task* task;
};

/** \brief Outputs by \ref resolvedName. */
using OutputsByPath = std::map<std::string, TaskOutput>;

/** \brief Adds an output. \throws UsageError if there is one of the same path */
void
addOutput (const std::string& name, const Task& task, OutputsByPath& outputs)
{
  const auto [entry, is_new] =
      outputs.emplace (resolvedName (name), TaskOutput{name, &task});
  if (is_new)
    return;
  const Task* const first_task = entry->second.task;
  if (first_task == &task)
    throw UsageError (name, "is the name of two outputs; give each its own");
  throw UsageError (first_task->input + " and " + task.input,
                    "would both be written to " + name +
                        "; rename one or give them in two runs");
}

/** \brief The outputs of all tasks: files, and folders of --planes-dir. */
struct AllOutputs {
  OutputsByPath files;
  OutputsByPath folders;

  bool
  isInFolder (const fs::path& file) const
  {
    return folders.count (file.parent_path().string()) > 0;
  }
};

/** \brief Collects the outputs of all tasks.
 * \param[in] fix what the user can do about an output that would overwrite an input:
 * the end of messages on it
 * \throws UsageError for two outputs of one name, or an output that is the input of its
 * own task */
AllOutputs
outputsOf (const std::vector<Task>& tasks, const std::string& fix)
{
  AllOutputs outputs;
  for (const Task& task : tasks) {
    for (const std::string& file : task.outputs.files()) {
      addOutput (file, task, outputs.files);
      if (isSameFile (task.input, file))
        throw UsageError (file, "is the input, too; " + fix);
    }
    if (!task.outputs.planes_dir.empty())
      addOutput (task.outputs.planes_dir, task, outputs.folders);
  }
  return outputs;
}

/** \brief Checks the names of all outputs.
 * \param[in] poses_file counts as an input; empty: no poses
 * \param[in] fix what the user can do about an output that would overwrite an input:
 * the end of messages on it
 * \throws UsageError if an output would overwrite another output or an input, or if the
 * folder of --planes-dir has an input, or an output that is named as a plane file */
void
checkClashes (const std::vector<Task>& tasks,
              const std::string& poses_file,
              const std::string& fix)
{
  const AllOutputs outputs = outputsOf (tasks, fix);
  for (const auto& [path, output] : outputs.files)
    if (outputs.isInFolder (path) && isPlaneFile (fs::path (path).filename().string()))
      throw UsageError (output.name,
                        "has the name of a plane in --planes-dir; give it another name "
                        "or folder");
  const auto output_over_poses = outputs.files.find (resolvedName (poses_file));
  if (output_over_poses != outputs.files.end())
    throw UsageError (output_over_poses->second.name,
                      "is the file of --poses, too; " + fix);
  for (const Task& task : tasks) {
    const std::string input = resolvedName (task.input);
    const auto output_over_input = outputs.files.find (input);
    if (output_over_input != outputs.files.end())
      throw UsageError (output_over_input->second.name, "is an input, too; " + fix);
    if (outputs.isInFolder (input))
      throw UsageError ("--planes-dir",
                        "the input " + task.input + " lies in it; give another folder");
  }
}

/** \brief Returns the task of one input of a batch. In the names of its outputs, the
 * name of the input replaces {}. */
Task
batchTask (const SegmentOptions& options, const std::string& input)
{
  const std::string name = fs::path (input).stem().string();
  const auto output_of = [&] (std::string pattern) {
    boost::replace_all (pattern, name_placeholder, name);
    return pattern.empty() ? "" : (fs::path (options.output_dir) / pattern).string();
  };
  const Outputs& given = options.outputs;
  Task task{input, {}};
  std::string extension = options.cloudExtension();
  if (isLasName (input) && options.format.empty())
    extension = extensionOf (input); // .laz stays .laz
  task.outputs.cloud = output_of (name_placeholder + extension);
  for (const OutputOption& option : output_options)
    task.outputs.*option.output = output_of (given.*option.output);
  if (given.planes.empty())
    task.outputs.planes = output_of (name_placeholder + std::string (".json"));
  return task;
}

} // namespace

std::vector<std::string>
Outputs::files() const
{
  std::vector<std::string> files;
  if (!cloud.empty())
    files.push_back (cloud);
  for (const OutputOption& option : output_options)
    if (const std::string& file = this->*option.output;
        !file.empty() && file != standard_stream && !option.extensions.empty())
      files.push_back (file);
  if (!trace.empty())
    for (const std::string& file : stageFiles())
      files.push_back ((fs::path (trace) / file).string());
  return files;
}

bool
readOptions (int argc, const char* const* argv, SegmentOptions& options)
{
  std::vector<std::string> arguments;
  CommandLine line (program_name, summary, PCL_OPS_VERSION);
  line.setUsage (
      {"INPUT [OUTPUT.pcd] [options]", "INPUT... --output-dir DIR [options]"},
      help_on_arguments);
  const auto store_argument = [&] (const std::string& text) {
    const bool is_output = arguments.size() == 1 && !options.isBatch();
    requireText (is_output ? "OUTPUT" : "INPUT", text);
    arguments.push_back (text);
  };
  line.addArguments ("INPUT", store_argument, "");
  declareOutputs (line, options);
  declareMethodOptions (line, options.method, options.detector);
  declareChoice (line, options.choice);
  declareFurtherOutputs (line, options);
  declareTracking (line, options.track);
  if (!line.parse (argc, argv))
    return false;
  checkMethodOptions (line, methodCalled (options.method));
  storeArguments (arguments, options);
  if (options.hull == "concave" && PCL_OPS_WITH_SURFACE == 0)
    throw UsageError ("--hull",
                      "concave is not in this build, which was made without PCL's "
                      "surface module; give convex");
  finishChoice (line, options.choice);
  options.has_meter = line.isGiven ("meter");
  options.detector.keeps_stages = !options.outputs.trace.empty();
  checkMap (line,
            options.outputs.planes,
            {options.outputs.edges, options.outputs.floor_plan});
  checkHaveEffect (line, options);
  checkOutputs (options);
  if (options.isBatch())
    checkBatch (options);
  return true;
}

Task
taskOf (const SegmentOptions& options)
{
  Task task{options.inputs[0], options.outputs};
  checkClashes ({task}, "", "give the output another name");
  for (const std::string& folder : {task.outputs.planes_dir, task.outputs.trace})
    if (!folder.empty())
      makeFolder (folder);
  for (const std::string& file : task.outputs.files())
    checkWritable (file);
  return task;
}

Batch
batchOf (const SegmentOptions& options)
{
  InputFiles inputs = findInputs (options.inputs);
  Batch batch;
  batch.problems = std::move (inputs.problems);
  for (const std::string& input : inputs.files)
    batch.tasks.push_back (batchTask (options, input));
  checkClashes (batch.tasks, options.track.poses_file, "give another --output-dir");
  if (!batch.tasks.empty())
    makeFolder (options.output_dir);
  return batch;
}

} // namespace pcl_ops::apps
