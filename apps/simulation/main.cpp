// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/exceptions.h>

#include "corner.h"
#include "dense_scan.h"
#include "depth_noise.h"
#include "packed_cloud.h"
#include "shapes.h"
#include "survey.h"
#include "town_files.h"
#include "walk_files.h"
#include <cli/command_line.h>
#include <cli/errors.h>
#include <cli/interruption.h>
#include <cli/memory.h>
#include <cli/program.h>
#include <io/cloud_file.h>
#include <io/output_file.h>
#include <io/pose_file.h>
#include <unistd.h>

#include <filesystem>
#include <iostream>
#include <limits>
#include <optional>

namespace {

using namespace pcl_ops::simulation;
using pcl_ops::apps::Range;

constexpr const char* program_name = "pcl_ops_simulate";

constexpr double most_seed = std::numeric_limits<std::uint32_t>::max();
/** \brief A point takes 32 bytes, and 16 more while it is written. */
constexpr double most_points = 1e7;
/** \brief Those of a town are never all in memory. */
constexpr double most_points_of_town = 1e12, most_tiles_of_town = 1e6;
/** \brief Image sizes for which a neighbourhood of pixels still means something [px].
 */
constexpr double smallest_image = 16;
constexpr double largest_image = 4096;

constexpr double usual_points_of_town = 1e6, usual_tiles = 4;
constexpr double most_frames = 1000;
/** \brief Beyond, an error is no small motion [degree, cm]. */
constexpr double largest_pose_error = 30;

struct Options {
  std::string output;
  std::string scene = "room";
  std::uint32_t seed = 1;
  DepthCamera camera;
  std::string profile = "correlated";
  double noise = 1.0;
  std::optional<double> points;
  std::optional<double> tiles;
  std::uint32_t frames = 50;
  PoseErrors pose_errors;
  bool organized = false;
  bool quiet = false;
};

/** \brief Whether the scene is a room; the others are scanned from everywhere. */
bool
isSeenByCamera (const std::string& scene)
{
  return scene == "room" || scene == "furniture" || scene == "walk";
}

void
declareScene (pcl_ops::apps::CommandLine& line, Options& options)
{
  line.addArgument ("OUTPUT.pcd",
                    options.output,
                    "the cloud to write (binary); of town and walk the folder");
  line.addChoice (
      "scene",
      {"room", "furniture", "survey", "shapes", "town", "walk"},
      options.scene,
      "a room, a corner of one with boards on posts, 36 houses on a ground, "
      "round shapes beside a ground, terraces of houses in tiles of .las, "
      "a camera's way through a room (room)");
  line.addNumber ("seed",
                  "S",
                  Range::from (0).upTo (most_seed),
                  options.seed,
                  "which room, furniture, houses or shapes (1)");
}

void
declareScan (pcl_ops::apps::CommandLine& line, Options& options)
{
  const Range image_size = Range::from (smallest_image).upTo (largest_image);
  line.addNumber ("width", "W", image_size, options.camera.width, "columns (640)");
  line.addNumber ("height", "H", image_size, options.camera.height, "rows (480)");
  line.addNumber ("noise",
                  "X",
                  Range::from (0).upTo (10),
                  options.noise,
                  "factor on the noise (1)");
  line.addChoice ("profile",
                  {"correlated", "raw", "none"},
                  options.profile,
                  "the noise: smoothed depth, raw depth, none (correlated)");
  line.addNumber ("points",
                  "N",
                  Range::from (1).upTo (most_points_of_town),
                  options.points,
                  "scan the whole room with N points instead of one camera image; "
                  "points of survey (600000), shapes (250000), about those of town "
                  "(1000000)");
  line.addNumber ("tiles",
                  "N",
                  Range::from (1).upTo (most_tiles_of_town),
                  options.tiles,
                  "tiles of town, rounded up to a square number (4)");
  line.addNumber ("frames",
                  "N",
                  Range::from (1).upTo (most_frames),
                  options.frames,
                  "clouds of walk (50)");
  line.addNumber ("pose-error",
                  "X",
                  Range::from (0).upTo (largest_pose_error),
                  options.pose_errors.each,
                  "degrees and cm each pose of walk is off in poses.txt (0)");
  line.addNumber ("drift",
                  "X",
                  Range::from (0).upTo (largest_pose_error),
                  options.pose_errors.drift,
                  "degrees and cm its way is off from pose to pose (0)");
  line.addFlag ("organized", options.organized, "keep pixels without a reading as NaN");
  line.addFlag ("quiet", options.quiet, "print nothing");
}

/** \brief Refuses options that the scene has no use for. */
void
checkOptions (const pcl_ops::apps::CommandLine& line, const Options& options)
{
  const bool is_town = options.scene == "town", is_walk = options.scene == "walk";
  for (const char* of_walk : {"frames", "pose-error", "drift"})
    if (line.isGiven (of_walk) && !is_walk)
      throw pcl_ops::apps::UsageError (std::string ("--") + of_walk,
                                       "is about --scene walk; leave it out");
  if (is_walk && options.points)
    throw pcl_ops::apps::UsageError ("--points",
                                     "is not for --scene walk; give --width, --height");
  if (options.tiles && !is_town)
    throw pcl_ops::apps::UsageError ("--tiles", "is about --scene town; leave it out");
  if (!is_town && options.points.value_or (1) > most_points)
    throw pcl_ops::apps::UsageError (
        "--points", "is more than 10000000, which only --scene town takes");
  if (!is_town && !is_walk && pcl_ops::apps::extensionOf (options.output) != ".pcd")
    throw pcl_ops::apps::UsageError (options.output,
                                     "has an unknown extension; give a .pcd file");
  for (const char* of_camera : {"width", "height", "profile", "organized"}) {
    line.forbidTogether ("points", of_camera);
    if (!isSeenByCamera (options.scene))
      line.forbidTogether ("scene", of_camera);
  }
}

bool
readOptions (int argc, const char* const* argv, Options& options)
{
  pcl_ops::apps::CommandLine line (
      program_name,
      "Simulates a furnished room as a depth camera sees it, or another scene. The\n"
      "field label is the true plane of each point: 0 none, 1..P by falling size.",
      PCL_OPS_VERSION);
  declareScene (line, options);
  declareScan (line, options);
  if (!line.parse (argc, argv))
    return false;
  checkOptions (line, options);
  return true;
}

NoiseParameters
noiseOf (const Options& options)
{
  const NoiseProfile profile = options.profile == "raw"    ? NoiseProfile::Raw
                               : options.profile == "none" ? NoiseProfile::None
                                                           : NoiseProfile::Correlated;
  NoiseParameters noise;
  noise.profile = profile;
  noise.scale = options.noise;
  return noise;
}

std::size_t
pointsOf (const Options& options, std::size_t usual)
{
  return options.points ? std::size_t (*options.points) : usual;
}

SimulatedCloud
simulateRoom (const Room& room, const Options& options)
{
  if (options.points)
    return scanDensely (room.scene, pointsOf (options, 1), options.noise, options.seed);
  DepthCamera camera = options.camera;
  camera.pose = drawCameraPose (room, camera, options.seed);
  const DepthImage image =
      measureDepth (room.scene, camera, noiseOf (options), options.seed);
  return toCloud (image,
                  camera,
                  room.scene,
                  options.organized ? CloudLayout::Organized : CloudLayout::Readings);
}

SimulatedCloud
simulate (const Options& options)
{
  if (options.scene == "survey")
    return scanSurvey (makeSurvey (options.seed),
                       pointsOf (options, points_of_survey),
                       options.noise,
                       options.seed);
  if (options.scene == "shapes")
    return scanShapes (makeShapes (options.seed),
                       pointsOf (options, points_of_shapes),
                       options.noise,
                       options.seed);
  return simulateRoom (options.scene == "furniture" ? makeFurnishedCorner (options.seed)
                                                    : makeRoom (options.seed),
                       options);
}

void
runTown (const Options& options)
{
  using pcl_ops::apps::ProgressStyle;
  const Town town = makeTown (options.seed,
                              options.points.value_or (usual_points_of_town),
                              tilesAlongASide (options.tiles.value_or (usual_tiles)));
  pcl_ops::apps::Progress progress (
      std::size_t (town.tiles) * town.tiles,
      std::cerr,
      options.quiet ? ProgressStyle::None
                    : pcl_ops::apps::progressStyleOf (::isatty (STDERR_FILENO) == 1),
      "tiles");
  const TownFiles written = saveTown (options.output, town, options.noise, progress);
  if (!options.quiet)
    std::cout << options.output << ": " << written.points << " points in "
              << written.files << " files\n";
}

void
runWalk (const Options& options)
{
  WalkRecording walk;
  walk.room = makeRoom (options.seed);
  walk.camera = options.camera;
  walk.poses = drawWalk (walk.room, walk.camera, options.frames, options.seed);
  walk.noise = noiseOf (options);
  walk.organized = options.organized;
  const std::uint64_t points = saveWalk (options.output, walk, options.seed);
  const std::string file =
      (std::filesystem::path (options.output) / "poses.txt").string();
  pcl_ops::apps::savePoses (file,
                            measured (walk.poses, options.pose_errors, options.seed));
  if (!options.quiet)
    std::cout << options.output << ": " << points << " points in " << options.frames
              << " frames, " << file << "\n";
}

void
runCloud (const Options& options)
{
  pcl_ops::apps::checkWritable (options.output);
  const SimulatedCloud simulated =
      pcl_ops::apps::inMemory (options.output, "give fewer --points", [&] {
        SimulatedCloud cloud = simulate (options);
        pcl_ops::apps::savePcd (options.output, packedCloud (cloud.cloud));
        return cloud;
      });
  if (!options.quiet)
    std::cout << options.output << ": " << simulated.cloud.size() << " points, "
              << simulated.planes.size() << " planes\n";
}

int
run (int argc, const char* const* argv)
{
  Options options;
  if (!readOptions (argc, argv, options))
    return pcl_ops::apps::ExitCode::done;
  if (options.scene == "town")
    runTown (options);
  else if (options.scene == "walk")
    runWalk (options);
  else
    runCloud (options);
  return pcl_ops::apps::ExitCode::done;
}

} // namespace

int
main (int argc, char** argv)
{
  using namespace pcl_ops::apps;
  noteInterruptions();
  const int code = runProgram (program_name, [&] { return run (argc, argv); });
  if (code != ExitCode::done)
    endAsInterrupted();
  return code;
}
