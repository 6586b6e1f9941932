// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "track_command.h"

#include <cli/command_line.h>
#include <cli/errors.h>
#include <cli/interruption.h>
#include <cli/program.h>
#include <evaluation/data/labelled_cloud.h>
#include <evaluation/metrics/kept_numbers.h>
#include <evaluation/report/text_table.h>
#include <io/inputs.h>
#include <nlohmann/json.hpp>
#include <numbers/fraction.h>

#include <filesystem>
#include <iostream>

namespace pcl_ops::evaluation {

namespace {

struct TrackOptions {
  std::string truth_folder, result_folder;
  std::size_t min_plane_points = 1;
  bool json = false;
};

bool
readOptions (int argc, const char* const* argv, TrackOptions& options)
{
  apps::CommandLine line (
      "pcl_ops_evaluate track",
      "Tells how many planes keep their number in a sequence of labelled clouds, as\n"
      "pcl_ops_segment --track writes it. The true label of a plane has to be the "
      "same\n"
      "in all clouds, as in those of pcl_ops_simulate --scene walk or drive.",
      PCL_OPS_VERSION);
  line.addArgument ("TRUTH", options.truth_folder, "folder of the true planes");
  line.addArgument (
      "RESULT", options.result_folder, "folder of the planes found, by the same names");
  line.addNumber ("min-plane-points",
                  "N",
                  apps::Range::from (0),
                  options.min_plane_points,
                  "true planes with fewer points in a cloud are not in it (1)");
  line.addFlag ("json", options.json, "print JSON instead of a table");
  return line.parse (argc, argv);
}

std::vector<std::string>
cloudsIn (const std::string& folder)
{
  const apps::InputFiles inputs = apps::findInputs ({folder});
  if (!inputs.problems.empty())
    throw apps::WorkError ("TRUTH", inputs.problems.front());
  return inputs.files;
}

KeptNumbers
keptIn (const TrackOptions& options)
{
  KeptNumbers kept;
  for (const std::string& file : cloudsIn (options.truth_folder)) {
    apps::stopIfInterrupted();
    const std::string result_file = (std::filesystem::path (options.result_folder) /
                                     std::filesystem::path (file).filename())
                                        .string();
    LabelledCloud truth = loadLabelledCloud (file);
    const LabelledCloud result = loadLabelledCloud (result_file);
    requireSamePoints (truth, result, result_file);
    dropSmallPlanes (truth.labels, options.min_plane_points);
    kept.add (truth.labels, result.labels);
  }
  return kept;
}

} // namespace

int
trackCommand (int argc, const char* const* argv)
{
  TrackOptions options;
  if (!readOptions (argc, argv, options))
    return apps::ExitCode::done;
  const KeptNumbers kept = keptIn (options);
  const nlohmann::ordered_json json{{"planes", kept.planes()},
                                    {"planes_kept", kept.planesKept()},
                                    {"sightings", kept.sightings()},
                                    {"sightings_kept", kept.sightingsKept()},
                                    {"numbers", kept.numbers()}};
  if (options.json) {
    std::cout << json.dump (2) << '\n';
    return apps::ExitCode::done;
  }
  const auto line = [] (std::size_t part, std::size_t whole) {
    return std::to_string (part) + " of " + std::to_string (whole) + ", " +
           percent (apps::fraction (part, whole, 1.0)) + " %";
  };
  std::cout << "true planes that keep their number   "
            << line (kept.planesKept(), kept.planes())
            << "\ntimes one has the number it had last "
            << line (kept.sightingsKept(), kept.sightings())
            << "\nnumbers given                        " << kept.numbers() << '\n';
  return apps::ExitCode::done;
}

} // namespace pcl_ops::evaluation
