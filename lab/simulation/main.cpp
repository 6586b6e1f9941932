// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <boost/format.hpp>

#include "scenes.h"
#include <cli/command_line.h>
#include <cli/errors.h>
#include <cli/program.h>
#include <cli/progress.h>
#include <io/labeled_pcd.h>
#include <io/las_file.h>
#include <io/output_file.h>
#include <io/pose_file.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <regex>
#include <set>

namespace {

using namespace pcl_ops::apps;
using namespace pcl_ops::simulation;
namespace fs = std::filesystem;

constexpr const char* program_name = "pcl_ops_simulate";

/** Scenes whose output is a folder of files. */
const std::set<std::string> scenes_with_folder = {"town", "walk", "drive"};

struct SimulationOptions {
  std::string output; // file or folder
  Simulation simulation;
  double tiles = 4;                   // number of tiles of a town
  std::uint32_t frames = 50;          // number of clouds of a walk or a drive
  std::string profile = "correlated"; // "raw": CameraNoise::is_raw
  PoseErrors pose_errors;             // of poses.txt of a walk or a drive
  bool quiet = false;

  /** Returns the path of a file in the output folder. */
  std::string
  inFolder (const std::string& name) const
  {
    return (fs::path (output) / name).string();
  }

  bool
  isOfAny (const std::set<std::string>& scenes) const
  {
    return scenes.count (simulation.scene) > 0;
  }
};

/** Limit for the memory: a point takes 32 bytes, and 16 more while it is written. */
constexpr double max_points = 1e7;
/** The points of a town are in memory for one tile at a time: with the most --tiles a
 * million. */
constexpr double max_points_of_town = 1e12;

void
declareSceneName (CommandLine& line, std::string& scene)
{
  line.add ("scene",
            scene,
            {"room",
             "furniture",
             "survey",
             "shapes",
             "town",
             "walk",
             "street",
             "drive",
             "airborne",
             "street-hills",
             "table",
             "plaster",
             "slabs",
             "missing",
             "room-kinect"})
      .help (
          "in this order: a room; a corner of one with boards on posts; 36 houses on "
          "a ground; round shapes beside a ground; terraces of houses in tiles of "
          ".las; a camera's way through a room; a street around a lidar; a lidar's "
          "way along a street; hills, woods and roofs from above; a street on hills "
          "with bushes; a table whose depth is bent; a room of wavy walls; a thin "
          "wall and a board from both sides; a camera's image of a room with readings "
          "at zero; one with depth in steps (room)");
}

void
declareScene (CommandLine& line, SimulationOptions& options)
{
  Simulation& simulation = options.simulation;
  line.addArgument ("OUTPUT.pcd",
                    options.output,
                    "the cloud to write (binary); of town, walk and drive the folder");
  declareSceneName (line, simulation.scene);
  line.add ("seed S",
            simulation.seed,
            from (0).upTo (std::numeric_limits<std::uint32_t>::max()))
      .help ("which room, furniture, houses, shapes, street and so on (1)");
  line.add ("points N", simulation.points, from (1).upTo (max_points_of_town))
      .help ("scan the whole room with N points instead of one camera image; "
             "points of survey (600000), shapes (250000), airborne, plaster and slabs "
             "(by the seed), about those of town (1000000)");
  line.add ("tiles N", options.tiles, from (1).upTo (1e6))
      .help ("tiles of town, rounded up to a square number (4)");
  line.add ("frames N", options.frames, from (1).upTo (1000))
      .help ("clouds of walk and drive (50)");
  // Errors of poses are small motions [degree, cm].
  const Range small_motion = from (0).upTo (30);
  line.add ("pose-error X", options.pose_errors.each, small_motion)
      .help ("degrees and cm each pose of these is off in poses.txt (0)");
  line.add ("drift X", options.pose_errors.drift, small_motion)
      .help ("degrees and cm their way is off from pose to pose (0)");
}

void
declareSensor (CommandLine& line, SimulationOptions& options)
{
  Simulation& simulation = options.simulation;
  // Sizes at which a neighborhood of pixels is still meaningful [px].
  const Range image_size = from (16).upTo (4096);
  line.add ("width W", simulation.camera.width, image_size).help ("columns (640)");
  line.add ("height H", simulation.camera.height, image_size).help ("rows (480)");
  line.add ("noise X", simulation.noise, from (0).upTo (10))
      .help ("factor on the noise (1)");
  line.add ("profile", options.profile, {"correlated", "raw"})
      .help ("the noise: smoothed depth, raw depth (correlated)");
  std::vector<std::string> lidars;
  for (const Lidar& lidar : known_lidars)
    lidars.push_back (lidar.name);
  line.add ("sensor", simulation.sensor, lidars)
      .help ("lidar of street and drive: rotating with that many beams, or one "
             "beam along a rosette (lidar-64)");
  line.add ("organized", simulation.organized)
      .help ("keep pixels or rays without a reading as NaN");
  line.add ("quiet", options.quiet).help ("print nothing");
}

/** \throw UsageError for an option of cameras or of rays with a scene that has no
 * camera or no rays */
void
checkSensorOptions (const CommandLine& line, const SimulationOptions& options)
{
  // The scenes table and room-kinect have noise of their own.
  const bool has_profile = options.isOfAny ({"room", "furniture", "walk", "missing"});
  const bool has_camera = has_profile || options.isOfAny ({"table", "room-kinect"});
  const bool has_rays =
      has_camera || options.isOfAny ({"street", "drive", "street-hills"});
  // No such option goes with --points, which scans without a sensor.
  const auto checkOption = [&line] (const char* option, bool scene_has_it) {
    line.forbidTogether ("points", option);
    if (!scene_has_it)
      line.forbidTogether ("scene", option);
  };
  checkOption ("width", has_camera);
  checkOption ("height", has_camera);
  checkOption ("profile", has_profile);
  checkOption ("organized", has_rays);
}

/** \throw UsageError for options that contradict the scene */
void
checkOptions (const CommandLine& line, const SimulationOptions& options)
{
  const Simulation& simulation = options.simulation;
  const std::string& scene = simulation.scene;
  const bool is_town = scene == "town";
  const bool is_walk = scene == "walk";
  const bool has_lidar = simulation.hasLidar();
  const auto refuse =
      [&line] (const std::string& option, bool is_wrong, const std::string& problem) {
        if (is_wrong && line.isGiven (option))
          throw UsageError ("--" + option, problem);
      };
  for (const char* option : {"frames", "pose-error", "drift"})
    refuse (option,
            !options.isOfAny ({"walk", "drive"}),
            "is about --scene walk and drive; leave it out");
  refuse ("sensor", !has_lidar, "is about --scene street and drive; leave it out");
  refuse ("organized",
          has_lidar && lidarOf (simulation.sensor).isRosette(),
          "is not for --sensor " + simulation.sensor +
              ", which has no rows; leave it out");
  refuse ("points", is_walk, "is not for --scene walk; give --width, --height");
  refuse ("points", has_lidar, "is not for --scene " + scene + "; give --sensor");
  refuse ("points",
          options.isOfAny ({"street-hills", "table", "missing", "room-kinect"}),
          "is not for --scene " + scene + "; leave it out");
  refuse ("tiles", !is_town, "is about --scene town; leave it out");
  refuse ("points",
          !is_town && simulation.points.value_or (1) > max_points,
          "is more than 10000000, which only --scene town takes; give fewer");
  if (!options.isOfAny (scenes_with_folder) && extensionOf (options.output) != ".pcd")
    throw UsageError (options.output, "has an unknown extension; give a .pcd file");
  checkSensorOptions (line, options);
}

/** Writes files into the output folder and shows the progress.
 * \param[in] noun what a file is, for the progress
 * \param[in] count number of files
 * \param[in] advice what the user can do if the memory is too small for a file
 * \param[in] nameOf returns the name of a file by its number
 * \param[in] save writes a file and returns its number of points; without points it
 * leaves no file
 * \return the summary to print */
template <typename NameOf, typename Save>
std::string
writeFiles (const SimulationOptions& options,
            std::size_t count,
            const char* noun,
            const char* advice,
            const NameOf& nameOf,
            const Save& save)
{
  using Style = ProgressStyle;
  const bool is_terminal = ::isatty (STDERR_FILENO) == 1;
  const Style style = options.quiet ? Style::None : progressStyleOf (is_terminal);
  makeFolder (options.output);
  Progress progress (count, std::cerr, style, noun);
  std::uint64_t files = 0;
  std::uint64_t points = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::string file = options.inFolder (nameOf (i));
    stopIfInterrupted();
    points += inMemory (file, advice, [&] { return save (i, file); });
    files += fs::exists (file);
    progress.step();
  }
  return options.output + ": " + std::to_string (points) + " points in " +
         std::to_string (files) + " files\n";
}

/** Removes a file of an earlier run if there is one; a folder stays. */
void
removeStale (const fs::path& file)
{
  std::error_code error;
  if (fs::is_regular_file (file, error) && !fs::remove (file, error))
    throw WorkError (file.string(),
                     "cannot be removed (" + error.message() + "); remove it");
}

/** Refuses a folder with files of an earlier, larger scene: they would be taken for
 * files of this one.
 * \param[in] name_of_file matches the names of files, with groups for their numbers
 * \param[in] end of the numbers in the names of this scene
 * \throws WorkError */
void
refuseFilesBeyond (const std::regex& name_of_file,
                   std::size_t end,
                   const std::string& folder)
{
  std::set<fs::path> beyond;
  std::error_code error; // where there is no folder yet, there are no files
  for (const fs::directory_entry& entry : fs::directory_iterator (folder, error)) {
    const std::string name = entry.path().filename().string();
    std::smatch groups; // the name, then its numbers
    if (std::regex_match (name, groups, name_of_file) &&
        std::any_of (
            groups.begin() + 1, groups.end(), [end] (const std::string& group) {
              return std::stoul (group) >= end;
            }))
      beyond.insert (entry.path());
  }
  if (beyond.empty())
    return;
  throw WorkError (beyond.begin()->string(),
                   beyond.size() == 1
                       ? "is of a larger scene; remove it or give another folder"
                       : "is one of " + std::to_string (beyond.size()) +
                             " files of a larger scene; remove them or give another "
                             "folder");
}

/** Writes a .las file for each tile that has points.
 * \return the summary to print */
std::string
writeTown (const SimulationOptions& options)
{
  constexpr double millimeter = 0.001;
  const Simulation& simulation = options.simulation;
  const Town town =
      makeTown (simulation.seed, simulation.points.value_or (1e6), options.tiles);
  refuseFilesBeyond (
      std::regex ("town_([0-9]{3})_([0-9]{3})\\.las"), town.tiles, options.output);
  const auto nameOf = [&town] (std::size_t i) {
    return str (boost::format ("town_%03u_%03u.las") % (i % town.tiles) %
                (i / town.tiles));
  };
  const auto save = [&] (std::size_t i, const std::string& file) {
    const auto column = std::uint32_t (i % town.tiles);
    const auto row = std::uint32_t (i / town.tiles);
    std::vector<LasPoint> points;
    for (const TownPoint& point : surveyTile (town, column, row, simulation.noise)) {
      LasPoint& record = points.emplace_back();
      record.label = point.label;
      const Eigen::Vector3d local = (point.position - town.corner) / millimeter; // [mm]
      for (int axis = 0; axis < 3; ++axis)
        record.raw[axis] = std::int32_t (std::lround (local[axis]));
    }
    if (points.empty())
      removeStale (file);
    else
      saveLas (file, points, millimeter, town.corner);
    return points.size();
  };
  const std::size_t tiles = std::size_t (town.tiles) * town.tiles;
  return writeFiles (options, tiles, "tiles", "give more --tiles", nameOf, save);
}

/** Writes the frames of a walk or a drive, and the measured poses.
 * \return the summary to print */
std::string
writeFrames (const SimulationOptions& options)
{
  constexpr const char* advice = "give a smaller image or another --sensor";
  const Simulation& simulation = options.simulation;
  const SensorView view = viewOf (simulation, options.frames);
  const auto nameOf = [] (std::size_t i) {
    return str (boost::format ("frame_%03u.pcd") % i);
  };
  const auto save = [&] (std::size_t i, const std::string& file) {
    const auto cloud = toSurfaceCloud (
        view.scan (i), Eigen::Isometry3d::Identity(), simulation.organized);
    saveLabeledPcd (file, cloud);
    return cloud.size();
  };
  refuseFilesBeyond (
      std::regex ("frame_([0-9]{3,9})\\.pcd"), options.frames, options.output);
  const std::string summary =
      writeFiles (options, options.frames, "frames", advice, nameOf, save);
  savePoses (options.inFolder ("poses.txt"),
             measuredPoses (view.poses, options.pose_errors, simulation.seed));
  return summary;
}

/** Writes a town, a walk or a drive, and prints the summary. */
void
writeFolder (const SimulationOptions& options)
{
  noteInterruptions();
  try {
    const std::string summary = options.simulation.scene == "town"
                                    ? writeTown (options)
                                    : writeFrames (options);
    if (!options.quiet)
      std::cout << summary;
  }
  catch (const Interrupted&) {
    throw WorkError (options.output,
                     "interrupted: each file in it is complete, but some are missing; "
                     "run it again");
  }
}

/** Writes one cloud and prints its numbers of points and planes. */
void
writeCloud (const SimulationOptions& options)
{
  checkWritable (options.output);
  std::optional<StageLines> lines;
  if (!options.quiet)
    lines.emplace (std::cerr).begin (options.output + ": simulating");
  const SimulatedCloud simulated =
      inMemory (options.output, "give fewer --points or a smaller image", [&] {
        SimulatedCloud cloud = simulate (options.simulation);
        saveLabeledPcd (options.output, cloud.cloud, cloud.is_ignored);
        return cloud;
      });
  lines.reset();
  if (!options.quiet)
    std::cout << options.output << ": " << simulated.cloud.size() << " points, "
              << simulated.planes.size() << " planes\n";
}

int
run (int argc, const char* const* argv)
{
  SimulationOptions options;
  CommandLine line (
      program_name,
      "Simulates a furnished room as a depth camera sees it, or another scene. The\n"
      "field label is the true plane of each point: 0 none, 1..P by falling size. "
      "Where\n"
      "the field ignore is 1, as on hilly ground, any answer is right.",
      PCL_OPS_VERSION);
  declareScene (line, options);
  declareSensor (line, options);
  if (!line.parse (argc, argv)) // the answer was --help or --version
    return ExitCode::done;
  checkOptions (line, options);
  options.simulation.has_raw_depth = options.profile == "raw";
  if (options.isOfAny (scenes_with_folder))
    writeFolder (options);
  else
    writeCloud (options);
  return ExitCode::done;
}

} // namespace

int
main (int argc, char** argv)
{
  const int code = runProgram (program_name, [&] { return run (argc, argv); });
  if (code != ExitCode::done)
    endAsInterrupted();
  return code;
}
