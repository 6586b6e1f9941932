// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "options.h"

#include "lidar.h"
#include <cli/command_line.h>
#include <cli/errors.h>
#include <io/output_file.h>

#include <limits>

namespace pcl_ops::simulation {

namespace {

using apps::CommandLine;
using apps::Range;
using apps::UsageError;

constexpr double max_seed = std::numeric_limits<std::uint32_t>::max();
/** \brief A point takes 32 bytes, and 16 more while it is written. */
constexpr double max_points = 1e7;
/** \brief Those of a town are never all in memory. */
constexpr double max_points_of_town = 1e12, max_tiles_of_town = 1e6;
/** \brief Image sizes for which a neighborhood of pixels still means something [px]. */
constexpr double min_image_size = 16, max_image_size = 4096;
constexpr double max_frames = 1000;
/** \brief Beyond, an error is no small motion [degree, cm]. */
constexpr double max_pose_error = 30;

/** \brief Whether the scene is a room; the others are scanned by a lidar or from
 * everywhere. */
bool
isSeenByCamera (const std::string& scene)
{
  return scene == "room" || scene == "furniture" || scene == "walk";
}

void
declareScene (CommandLine& line, SimulationOptions& options)
{
  line.addArgument ("OUTPUT.pcd",
                    options.output,
                    "the cloud to write (binary); of town, walk and drive the folder");
  line.addChoice (
      "scene",
      {"room", "furniture", "survey", "shapes", "town", "walk", "street", "drive"},
      options.scene,
      "a room, a corner of one with boards on posts, 36 houses on a ground, "
      "round shapes beside a ground, terraces of houses in tiles of .las, "
      "a camera's way through a room, a street around a lidar, "
      "a lidar's way along a street (room)");
  line.addNumber ("seed",
                  "S",
                  Range::from (0).upTo (max_seed),
                  options.seed,
                  "which room, furniture, houses, shapes or street (1)");
}

void
declareScan (CommandLine& line, SimulationOptions& options)
{
  const Range image_size = Range::from (min_image_size).upTo (max_image_size);
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
                  Range::from (1).upTo (max_points_of_town),
                  options.points,
                  "scan the whole room with N points instead of one camera image; "
                  "points of survey (600000), shapes (250000), about those of town "
                  "(1000000)");
  line.addFlag (
      "organized", options.organized, "keep pixels or rays without a reading as NaN");
  line.addFlag ("quiet", options.quiet, "print nothing");
}

void
declareOtherScenes (CommandLine& line, SimulationOptions& options)
{
  line.addNumber ("tiles",
                  "N",
                  Range::from (1).upTo (max_tiles_of_town),
                  options.tiles,
                  "tiles of town, rounded up to a square number (4)");
  line.addChoice ("sensor",
                  lidarNames(),
                  options.sensor,
                  "lidar of street and drive: rotating with that many beams, or one "
                  "beam along a rosette (lidar-64)");
  line.addNumber ("frames",
                  "N",
                  Range::from (1).upTo (max_frames),
                  options.frames,
                  "clouds of walk and drive (50)");
  line.addNumber ("pose-error",
                  "X",
                  Range::from (0).upTo (max_pose_error),
                  options.pose_errors.each,
                  "degrees and cm each pose of these is off in poses.txt (0)");
  line.addNumber ("drift",
                  "X",
                  Range::from (0).upTo (max_pose_error),
                  options.pose_errors.drift,
                  "degrees and cm their way is off from pose to pose (0)");
}

/** \brief Refuses options that the scene has no use for. */
void
checkOptions (const CommandLine& line, const SimulationOptions& options)
{
  const std::string& scene = options.scene;
  const bool is_town = scene == "town", is_lidar = isSeenByLidar (scene);
  const auto refuse =
      [&line] (const std::string& option, bool is_wrong, const std::string& problem) {
        if (is_wrong && line.isGiven (option))
          throw UsageError ("--" + option, problem);
      };
  for (const char* of_frames : {"frames", "pose-error", "drift"})
    refuse (of_frames,
            !isOnTheWay (scene),
            "is about --scene walk and drive; leave it out");
  refuse ("sensor", !is_lidar, "is about --scene street and drive; leave it out");
  refuse ("organized",
          is_lidar && lidarOf (options.sensor).isRosette(),
          "is not for --sensor " + options.sensor + ", which has no rows");
  refuse ("points", scene == "walk", "is not for --scene walk; give --width, --height");
  refuse ("points", is_lidar, "is not for --scene " + scene + "; give --sensor");
  refuse ("tiles", !is_town, "is about --scene town; leave it out");
  refuse ("points",
          !is_town && options.points.value_or (1) > max_points,
          "is more than 10000000, which only --scene town takes");
  if (!isOfManyFiles (scene) && apps::extensionOf (options.output) != ".pcd")
    throw UsageError (options.output, "has an unknown extension; give a .pcd file");
  for (const std::string of_camera : {"width", "height", "profile", "organized"}) {
    line.forbidTogether ("points", of_camera);
    const bool is_of_lidar = is_lidar && of_camera == "organized";
    if (!isSeenByCamera (scene) && !is_of_lidar)
      line.forbidTogether ("scene", of_camera);
  }
}

} // namespace

bool
readOptions (int argc, const char* const* argv, SimulationOptions& options)
{
  CommandLine line (
      program_name,
      "Simulates a furnished room as a depth camera sees it, or another scene. The\n"
      "field label is the true plane of each point: 0 none, 1..P by falling size.",
      PCL_OPS_VERSION);
  declareScene (line, options);
  declareScan (line, options);
  declareOtherScenes (line, options);
  if (!line.parse (argc, argv))
    return false;
  checkOptions (line, options);
  return true;
}

} // namespace pcl_ops::simulation
