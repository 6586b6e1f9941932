// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "poses.h"
#include "simulate.h"
#include "town.h"
#include <cli/command_line.h>
#include <cli/errors.h>
#include <cli/program.h>
#include <cli/progress.h>
#include <io/labeled_pcd.h>
#include <io/las_file.h>
#include <io/output_file.h>
#include <io/pose_file.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <limits>
#include <optional>

namespace {

using namespace pcl_ops::simulation;
namespace apps = pcl_ops::apps;
namespace fs = std::filesystem;

constexpr const char* program_name = "pcl_ops_simulate";

/** \brief What the command line asks for. */
struct SimulationOptions {
  std::string output;
  Simulation simulation;
  double tiles = 4;
  std::uint32_t frames = 50;
  PoseErrors pose_errors;
  bool quiet = false;

  bool
  isOnTheWay () const
  {
    return simulation.scene == "walk" || simulation.scene == "drive";
  }

  /** \brief Whether the output is a folder. */
  bool
  isOfManyFiles () const
  {
    return simulation.scene == "town" || isOnTheWay();
  }
};

using apps::CommandLine;
using apps::Range;
using apps::UsageError;

constexpr double max_seed = std::numeric_limits<std::uint32_t>::max();
/** \brief A point takes 32 bytes, and 16 more while it is written; those of a town are
 * never all in memory. */
constexpr double max_points = 1e7, max_points_of_town = 1e12, max_tiles = 1e6;
/** \brief Image sizes for which a neighborhood of pixels still means something [px]. */
constexpr double min_image_size = 16, max_image_size = 4096;
constexpr double max_frames = 1000;
/** \brief Beyond, an error is no small motion [degree, cm]. */
constexpr double max_pose_error = 30;

void
declareScene (CommandLine& line, SimulationOptions& options)
{
  Simulation& simulation = options.simulation;
  line.addArgument ("OUTPUT.pcd",
                    options.output,
                    "the cloud to write (binary); of town, walk and drive the folder");
  line.addChoice (
      "scene",
      {"room", "furniture", "survey", "shapes", "town", "walk", "street", "drive"},
      simulation.scene,
      "a room, a corner of one with boards on posts, 36 houses on a ground, "
      "round shapes beside a ground, terraces of houses in tiles of .las, "
      "a camera's way through a room, a street around a lidar, "
      "a lidar's way along a street (room)");
  line.addNumber ("seed",
                  "S",
                  Range::from (0).upTo (max_seed),
                  simulation.seed,
                  "which room, furniture, houses, shapes or street (1)");
  line.addNumber ("points",
                  "N",
                  Range::from (1).upTo (max_points_of_town),
                  simulation.points,
                  "scan the whole room with N points instead of one camera image; "
                  "points of survey (600000), shapes (250000), about those of town "
                  "(1000000)");
  line.addNumber ("tiles",
                  "N",
                  Range::from (1).upTo (max_tiles),
                  options.tiles,
                  "tiles of town, rounded up to a square number (4)");
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

void
declareSensor (CommandLine& line, SimulationOptions& options)
{
  Simulation& simulation = options.simulation;
  const Range image_size = Range::from (min_image_size).upTo (max_image_size);
  line.addNumber ("width", "W", image_size, simulation.camera.width, "columns (640)");
  line.addNumber ("height", "H", image_size, simulation.camera.height, "rows (480)");
  line.addNumber ("noise",
                  "X",
                  Range::from (0).upTo (10),
                  simulation.noise,
                  "factor on the noise (1)");
  line.addValue ("profile",
                 "correlated|raw",
                 "the noise: smoothed depth, raw depth (correlated)",
                 [&simulation] (const std::string& profile) {
                   simulation.has_raw_depth = profile == "raw";
                   if (profile != "raw" && profile != "correlated")
                     throw UsageError ("--profile", "is none; give correlated or raw");
                 });
  std::vector<std::string> lidars;
  for (const Lidar& lidar : knownLidars())
    lidars.push_back (lidar.name);
  line.addChoice ("sensor",
                  lidars,
                  simulation.sensor,
                  "lidar of street and drive: rotating with that many beams, or one "
                  "beam along a rosette (lidar-64)");
  line.addFlag ("organized",
                simulation.organized,
                "keep pixels or rays without a reading as NaN");
  line.addFlag ("quiet", options.quiet, "print nothing");
}

/** \brief Refuses options that the scene has no use for. */
void
checkOptions (const CommandLine& line, const SimulationOptions& options)
{
  const Simulation& simulation = options.simulation;
  const std::string& scene = simulation.scene;
  const bool is_town = scene == "town", is_walk = scene == "walk";
  const bool has_lidar = scene == "street" || scene == "drive";
  const bool has_camera = scene == "room" || scene == "furniture" || is_walk;
  const auto refuse =
      [&line] (const std::string& option, bool is_wrong, const std::string& problem) {
        if (is_wrong && line.isGiven (option))
          throw UsageError ("--" + option, problem);
      };
  for (const char* of_way : {"frames", "pose-error", "drift"})
    refuse (
        of_way, !options.isOnTheWay(), "is about --scene walk and drive; leave it out");
  refuse ("sensor", !has_lidar, "is about --scene street and drive; leave it out");
  refuse ("organized",
          has_lidar && lidarOf (simulation.sensor).isRosette(),
          "is not for --sensor " + simulation.sensor +
              ", which has no rows; leave it out");
  refuse ("points", is_walk, "is not for --scene walk; give --width, --height");
  refuse ("points", has_lidar, "is not for --scene " + scene + "; give --sensor");
  refuse ("tiles", !is_town, "is about --scene town; leave it out");
  refuse ("points",
          !is_town && simulation.points.value_or (1) > max_points,
          "is more than 10000000, which only --scene town takes; give fewer");
  if (!options.isOfManyFiles() && apps::extensionOf (options.output) != ".pcd")
    throw UsageError (options.output, "has an unknown extension; give a .pcd file");
  for (const std::string of_camera : {"width", "height", "profile", "organized"}) {
    line.forbidTogether ("points", of_camera);
    if (!has_camera && !(has_lidar && of_camera == "organized"))
      line.forbidTogether ("scene", of_camera);
  }
}

/** \return false if the answer was --help or --version */
bool
readOptions (int argc, const char* const* argv, SimulationOptions& options)
{
  CommandLine line (
      program_name,
      "Simulates a furnished room as a depth camera sees it, or another scene. The\n"
      "field label is the true plane of each point: 0 none, 1..P by falling size.",
      PCL_OPS_VERSION);
  declareScene (line, options);
  declareSensor (line, options);
  if (!line.parse (argc, argv))
    return false;
  checkOptions (line, options);
  return true;
}

/** \brief Writes files one after the other into the output folder. */
class FolderWriter {
public:
  FolderWriter (const SimulationOptions& options, std::size_t steps, const char* noun)
  : folder_ (options.output)
  , progress_ (steps,
               std::cerr,
               options.quiet ? apps::ProgressStyle::None
                             : apps::progressStyleOf (::isatty (STDERR_FILENO) == 1),
               noun)
  {
    apps::makeFolder (folder_);
  }

  /** \brief A name of printf's pattern in the folder. */
  template <typename... Numbers>
  std::string
  nameOf (const char* pattern, Numbers... numbers) const
  {
    std::array<char, 32> name{};
    std::snprintf (name.data(), name.size(), pattern, numbers...);
    return (fs::path (folder_) / name.data()).string();
  }

  /** \param[in] save writes a file and returns its number of points */
  template <typename Save>
  void
  write (const std::string& file, const char* fix, const Save& save)
  {
    apps::stopIfInterrupted();
    points_ += apps::inMemory (file, fix, save);
    files_ += fs::exists (file);
    progress_.step();
  }

  std::string
  summary () const
  {
    return folder_ + ": " + std::to_string (points_) + " points in " +
           std::to_string (files_) + " files\n";
  }

private:
  std::string folder_;
  apps::Progress progress_;
  std::uint64_t files_ = 0, points_ = 0;
};

std::vector<apps::LasPoint>
toLas (const std::vector<TownPoint>& points, const Eigen::Vector3d& offset, double unit)
{
  std::vector<apps::LasPoint> records;
  records.reserve (points.size());
  for (const TownPoint& point : points) {
    const Eigen::Vector3d local = (point.position - offset) / unit;
    records.push_back ({{std::int32_t (std::lround (local.x())),
                         std::int32_t (std::lround (local.y())),
                         std::int32_t (std::lround (local.z()))},
                        point.label});
  }
  return records;
}

/** \brief Writes each tile as town_000_000.las and so on, column and row, with one tile
 * in memory. Tiles without points have no file. */
std::string
writeTown (const SimulationOptions& options)
{
  constexpr double millimeter = 0.001;
  const Simulation& simulation = options.simulation;
  const Town town =
      makeTown (simulation.seed, simulation.points.value_or (1e6), options.tiles);
  FolderWriter writer (options, std::size_t (town.tiles) * town.tiles, "tiles");
  for (std::uint32_t row = 0; row < town.tiles; ++row)
    for (std::uint32_t column = 0; column < town.tiles; ++column) {
      const std::string file = writer.nameOf ("town_%03u_%03u.las", column, row);
      writer.write (file, "give more --tiles", [&] {
        const auto points = toLas (
            surveyTile (town, column, row, simulation.noise), town.corner, millimeter);
        if (!points.empty())
          apps::saveLas (file, points, millimeter, town.corner);
        return points.size();
      });
    }
  return writer.summary();
}

/** \brief Writes frames as frame_000.pcd and so on, and poses. */
std::string
writeWay (const SimulationOptions& options)
{
  constexpr const char* pattern = "frame_%03zu.pcd";
  const SensorView way = viewOf (options.simulation, options.frames);
  FolderWriter writer (options, options.frames, "frames");
  for (std::size_t i = 0; i < options.frames; ++i) {
    const std::string file = writer.nameOf (pattern, i);
    writer.write (file, "give a smaller image or another --sensor", [&] {
      const auto cloud = toSurfaceCloud (
          way.scan (i), Eigen::Isometry3d::Identity(), options.simulation.organized);
      apps::saveLabeledPcd (file, cloud);
      return cloud.size();
    });
  }
  // Those of a longer walk before it would be taken for frames of this one.
  for (std::size_t i = options.frames; fs::remove (writer.nameOf (pattern, i));)
    ++i;
  apps::savePoses ((fs::path (options.output) / "poses.txt").string(),
                   measured (way.poses, options.pose_errors, options.simulation.seed));
  return writer.summary();
}

/** \brief Writes files one after the other, and ends behind one of them on Ctrl-C. */
void
runFiles (const SimulationOptions& options)
{
  apps::noteInterruptions();
  try {
    const std::string summary =
        options.simulation.scene == "town" ? writeTown (options) : writeWay (options);
    if (!options.quiet)
      std::cout << summary;
  }
  catch (const apps::Interrupted&) {
    throw apps::WorkError (
        options.output, "interrupted: its files are whole, but not all; run it again");
  }
}

void
runCloud (const SimulationOptions& options)
{
  apps::checkWritable (options.output);
  std::optional<apps::StageLines> lines;
  if (!options.quiet)
    lines.emplace (std::cerr).begin (options.output + ": simulating");
  const SimulatedCloud simulated =
      apps::inMemory (options.output, "give fewer --points or a smaller image", [&] {
        SimulatedCloud cloud = simulate (options.simulation);
        apps::saveLabeledPcd (options.output, cloud.cloud);
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
  if (!readOptions (argc, argv, options))
    return apps::ExitCode::done;
  options.isOfManyFiles() ? runFiles (options) : runCloud (options);
  return apps::ExitCode::done;
}

} // namespace

int
main (int argc, char** argv)
{
  const int code = apps::runProgram (program_name, [&] { return run (argc, argv); });
  if (code != apps::ExitCode::done)
    apps::endAsInterrupted();
  return code;
}
