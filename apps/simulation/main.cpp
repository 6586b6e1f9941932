// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/exceptions.h>

#include "corner.h"
#include "dense_scan.h"
#include "depth_noise.h"
#include "options.h"
#include "packed_cloud.h"
#include "shapes.h"
#include "street.h"
#include "survey.h"
#include "town_files.h"
#include "walk_files.h"
#include <cli/errors.h>
#include <cli/interruption.h>
#include <cli/memory.h>
#include <cli/program.h>
#include <cli/progress.h>
#include <cli/stage_lines.h>
#include <io/cloud_file.h>
#include <io/output_file.h>
#include <io/pose_file.h>
#include <unistd.h>

#include <filesystem>
#include <iostream>
#include <optional>

namespace {

using namespace pcl_ops::simulation;

constexpr double usual_points_of_town = 1e6, usual_tiles = 4;

NoiseParameters
noiseOf (const SimulationOptions& options)
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
pointsOf (const SimulationOptions& options, std::size_t usual)
{
  return options.points ? std::size_t (*options.points) : usual;
}

CloudLayout
layoutOf (const SimulationOptions& options)
{
  return options.organized ? CloudLayout::Organized : CloudLayout::Readings;
}

SimulatedCloud
simulateRoom (const Room& room, const SimulationOptions& options)
{
  if (options.points)
    return scanDensely (room.scene, pointsOf (options, 1), options.noise, options.seed);
  DepthCamera camera = options.camera;
  camera.pose = drawCameraPose (room, camera, options.seed);
  const DepthImage image =
      measureDepth (room.scene, camera, noiseOf (options), options.seed);
  return toCloud (image, camera, room.scene, layoutOf (options));
}

SimulatedCloud
simulateStreet (const SimulationOptions& options)
{
  const Street street = makeStreet (options.seed);
  Lidar lidar = lidarOf (options.sensor);
  lidar.pose = drawSensorPose (street, options.seed);
  return toCloud (scanAround (street.scene, lidar, options.noise, options.seed),
                  lidar,
                  street.scene,
                  layoutOf (options));
}

SimulatedCloud
simulate (const SimulationOptions& options)
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
  if (options.scene == "street")
    return simulateStreet (options);
  return simulateRoom (options.scene == "furniture" ? makeFurnishedCorner (options.seed)
                                                    : makeRoom (options.seed),
                       options);
}

pcl_ops::apps::ProgressStyle
progressOf (const SimulationOptions& options)
{
  return options.quiet ? pcl_ops::apps::ProgressStyle::None
                       : pcl_ops::apps::progressStyleOf (::isatty (STDERR_FILENO) == 1);
}

void
runTown (const SimulationOptions& options)
{
  const Town town = makeTown (options.seed,
                              options.points.value_or (usual_points_of_town),
                              tilesAlongASide (options.tiles.value_or (usual_tiles)));
  pcl_ops::apps::Progress progress (
      std::size_t (town.tiles) * town.tiles, std::cerr, progressOf (options), "tiles");
  const TownFiles written = saveTown (options.output, town, options.noise, progress);
  if (!options.quiet)
    std::cout << options.output << ": " << written.points << " points in "
              << written.files << " files\n";
}

/** \brief Writes frames and poses. */
void
saveFrames (const SimulationOptions& options,
            const Poses& poses,
            const WalkRecording& walk)
{
  pcl_ops::apps::Progress progress (
      poses.size(), std::cerr, progressOf (options), "frames");
  const std::uint64_t points = saveWalk (options.output, walk, progress);
  const std::string file =
      (std::filesystem::path (options.output) / "poses.txt").string();
  pcl_ops::apps::savePoses (file, measured (poses, options.pose_errors, options.seed));
  if (!options.quiet)
    std::cout << options.output << ": " << points << " points in " << options.frames
              << " frames, " << file << "\n";
}

void
runWalk (const SimulationOptions& options)
{
  const Room room = makeRoom (options.seed);
  const Poses poses = drawWalk (room, options.camera, options.frames, options.seed);
  saveFrames (options,
              poses,
              recorded (room.scene,
                        options.camera,
                        poses,
                        noiseOf (options),
                        layoutOf (options),
                        options.seed));
}

void
runDrive (const SimulationOptions& options)
{
  const Street street = makeStreet (options.seed);
  const Poses poses = drawDrive (street, options.frames, options.seed);
  saveFrames (options,
              poses,
              recorded (street.scene,
                        lidarOf (options.sensor),
                        poses,
                        options.noise,
                        layoutOf (options),
                        options.seed));
}

/** \brief Writes files one after the other, and ends behind one of them on Ctrl-C. */
void
runFiles (const SimulationOptions& options, void (*write) (const SimulationOptions&))
{
  pcl_ops::apps::noteInterruptions();
  try {
    write (options);
  }
  catch (const pcl_ops::apps::Interrupted&) {
    throw pcl_ops::apps::WorkError (
        options.output, "interrupted: its files are whole, but not all; run it again");
  }
}

void
runCloud (const SimulationOptions& options)
{
  pcl_ops::apps::checkWritable (options.output);
  std::optional<pcl_ops::apps::StageLines> lines;
  if (!options.quiet)
    lines.emplace (std::cerr).begin (options.output + ": simulating");
  const SimulatedCloud simulated =
      pcl_ops::apps::inMemory (options.output, "give fewer --points", [&] {
        SimulatedCloud cloud = simulate (options);
        pcl_ops::apps::savePcd (options.output, packedCloud (cloud.cloud));
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
    return pcl_ops::apps::ExitCode::done;
  if (options.scene == "town")
    runFiles (options, runTown);
  else if (options.scene == "walk")
    runFiles (options, runWalk);
  else if (options.scene == "drive")
    runFiles (options, runDrive);
  else
    runCloud (options);
  return pcl_ops::apps::ExitCode::done;
}

} // namespace

int
main (int argc, char** argv)
{
  using namespace pcl_ops::apps;
  const int code = runProgram (program_name, [&] { return run (argc, argv); });
  if (code != ExitCode::done)
    endAsInterrupted();
  return code;
}
