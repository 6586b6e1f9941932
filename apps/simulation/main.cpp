// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "options.h"
#include "scene_files.h"
#include "shapes.h"
#include "street.h"
#include "survey.h"
#include <cli/errors.h>
#include <cli/interruption.h>
#include <cli/program.h>
#include <cli/progress.h>
#include <io/cloud_file.h>
#include <io/output_file.h>
#include <io/pose_file.h>
#include <unistd.h>

#include <filesystem>
#include <functional>
#include <iostream>
#include <optional>

namespace {

using namespace pcl_ops::simulation;
namespace apps = pcl_ops::apps;

/** \brief A scene, and where a sensor looks at it from. */
struct View {
  Scene scene;
  Poses poses;
  /** \brief Of a pose; the noise is by the seed, and a rosette by the number of the
   * scan in a row of them. */
  std::function<Scan (const Scene&,
                      const Eigen::Isometry3d& pose,
                      std::uint32_t seed,
                      std::size_t number)>
      scan;
  /** \brief What to do if a scan does not fit into the memory. */
  const char* advice;
};

View
viewOfStreet (const SimulationOptions& options)
{
  const Street street = makeStreet (options.seed);
  const auto scan = [lidar = lidarOf (options.sensor), noise = options.noise] (
                        const auto& scene, const auto& pose, auto seed, auto number) {
    return scanAround (scene, lidar, pose, noise, seed, number);
  };
  const Poses poses = options.scene == "drive"
                          ? drawDrive (street, options.frames, options.seed)
                          : Poses{drawSensorPose (street, options.seed)};
  return {street.scene, poses, scan, "give another --sensor"};
}

Room
roomOf (const SimulationOptions& options)
{
  return options.scene == "furniture" ? makeFurnishedCorner (options.seed)
                                      : makeRoom (options.seed);
}

View
viewOfRoom (const SimulationOptions& options)
{
  const Room room = roomOf (options);
  NoiseParameters noise;
  noise.profile = options.profile == "raw"    ? NoiseProfile::Raw
                  : options.profile == "none" ? NoiseProfile::None
                                              : NoiseProfile::Correlated;
  noise.scale = options.noise;
  const auto scan = [camera = options.camera,
                     noise] (const auto& scene, const auto& pose, auto seed, auto) {
    return scanByCamera (scene, camera, pose, noise, seed);
  };
  const Poses poses = options.scene == "walk"
                          ? drawWalk (room, options.frames, options.seed)
                          : Poses{drawCameraPose (room, options.seed)};
  return {room.scene, poses, scan, "give a smaller --width and --height"};
}

View
viewOf (const SimulationOptions& options)
{
  return isSeenByLidar (options.scene) ? viewOfStreet (options) : viewOfRoom (options);
}

SimulatedCloud
simulate (const SimulationOptions& options)
{
  const auto pointsOr = [&options] (std::size_t usual) {
    return options.points ? std::size_t (*options.points) : usual;
  };
  const std::uint32_t seed = options.seed;
  if (options.scene == "survey")
    return scanSurvey (
        makeSurvey (seed), pointsOr (points_of_survey), options.noise, seed);
  if (options.scene == "shapes")
    return scanShapes (
        makeShapes (seed), pointsOr (points_of_shapes), options.noise, seed);
  if (options.points)
    return scanDensely (roomOf (options).scene, pointsOr (1), options.noise, seed);
  const View view = viewOf (options);
  const Eigen::Isometry3d& pose = view.poses.front();
  return toCloud (
      view.scan (view.scene, pose, seed, 0), pose, view.scene, options.layout());
}

apps::ProgressStyle
progressOf (const SimulationOptions& options)
{
  return options.quiet ? apps::ProgressStyle::None
                       : apps::progressStyleOf (::isatty (STDERR_FILENO) == 1);
}

void
runTown (const SimulationOptions& options)
{
  constexpr double usual_points = 1e6, usual_tiles = 4;
  const Town town = makeTown (options.seed,
                              options.points.value_or (usual_points),
                              options.tiles.value_or (usual_tiles));
  apps::Progress progress (
      std::size_t (town.tiles) * town.tiles, std::cerr, progressOf (options), "tiles");
  const WrittenFiles written = saveTown (options.output, town, options.noise, progress);
  if (!options.quiet)
    std::cout << options.output << ": " << written.points << " points in "
              << written.files << " files\n";
}

/** \brief Writes a walk or a drive: frames and poses. */
void
runFrames (const SimulationOptions& options)
{
  const View view = viewOf (options);
  const auto look = [&] (std::size_t frame) {
    const Scan scan = view.scan (
        view.scene, view.poses[frame], options.seed + std::uint32_t (frame), frame);
    return toSurfaceCloud (scan, Eigen::Isometry3d::Identity(), options.layout());
  };
  apps::Progress progress (
      view.poses.size(), std::cerr, progressOf (options), "frames");
  const WrittenFiles written =
      saveFrames (options.output, view.poses.size(), look, view.advice, progress);
  const std::string file =
      (std::filesystem::path (options.output) / "poses.txt").string();
  apps::savePoses (file, measured (view.poses, options.pose_errors, options.seed));
  if (!options.quiet)
    std::cout << options.output << ": " << written.points << " points in "
              << written.files << " frames, " << file << "\n";
}

/** \brief Writes files one after the other, and ends behind one of them on Ctrl-C. */
void
runFiles (const SimulationOptions& options)
{
  apps::noteInterruptions();
  try {
    options.scene == "town" ? runTown (options) : runFrames (options);
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
      apps::inMemory (options.output, "give fewer --points", [&] {
        SimulatedCloud cloud = simulate (options);
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
  if (readOptions (argc, argv, options))
    isOfManyFiles (options.scene) ? runFiles (options) : runCloud (options);
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
