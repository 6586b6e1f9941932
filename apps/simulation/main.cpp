// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "options.h"
#include "poses.h"
#include "scene_files.h"
#include <cli/errors.h>
#include <cli/interruption.h>
#include <cli/program.h>
#include <cli/progress.h>
#include <io/labeled_pcd.h>
#include <io/output_file.h>
#include <io/pose_file.h>
#include <unistd.h>

#include <filesystem>
#include <iostream>
#include <optional>

namespace {

using namespace pcl_ops::simulation;
namespace apps = pcl_ops::apps;

apps::Progress
progressOf (const SimulationOptions& options, std::size_t steps, const char* noun)
{
  const bool is_terminal = ::isatty (STDERR_FILENO) == 1;
  return {steps,
          std::cerr,
          options.quiet ? apps::ProgressStyle::None
                        : apps::progressStyleOf (is_terminal),
          noun};
}

WrittenFiles
writeTown (const SimulationOptions& options)
{
  const Simulation& simulation = options.simulation;
  const Town town =
      makeTown (simulation.seed, simulation.points.value_or (1e6), options.tiles);
  apps::Progress progress =
      progressOf (options, std::size_t (town.tiles) * town.tiles, "tiles");
  return saveTown (options.output, town, simulation.noise, progress);
}

/** \brief Writes frames and poses. */
WrittenFiles
writeWay (const SimulationOptions& options)
{
  const WayView way = simulateWay (options.simulation, options.frames);
  apps::Progress progress = progressOf (options, options.frames, "frames");
  const WrittenFiles written =
      saveFrames (options.output, options.frames, way.look, progress);
  apps::savePoses ((std::filesystem::path (options.output) / "poses.txt").string(),
                   measured (way.poses, options.pose_errors, options.simulation.seed));
  return written;
}

/** \brief Writes files one after the other, and ends behind one of them on Ctrl-C. */
void
runFiles (const SimulationOptions& options)
{
  apps::noteInterruptions();
  try {
    const WrittenFiles written =
        options.simulation.scene == "town" ? writeTown (options) : writeWay (options);
    if (!options.quiet)
      std::cout << options.output << ": " << written.points << " points in "
                << written.files << " files\n";
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
