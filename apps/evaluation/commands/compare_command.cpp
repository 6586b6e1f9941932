// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "commands.h"
#include <cli/command_line.h>
#include <cli/program.h>
#include <evaluation/data/labeled_cloud.h>
#include <evaluation/metrics/metrics.h>
#include <nlohmann/json.hpp>

#include <iomanip>
#include <iostream>
#include <iterator>

namespace pcl_ops::evaluation {

namespace {

struct CompareOptions {
  std::string truth_file;
  std::string result_file;
  Eigen::Vector3f up = Eigen::Vector3f::UnitZ();
  std::size_t min_plane_points = 1;
  bool json = false;
};

bool
readOptions (int argc, const char* const* argv, CompareOptions& options)
{
  apps::CommandLine line ("pcl_ops_evaluate compare",
                          "Compares the planes of two labeled clouds of the same "
                          "points (field label, 0: no plane).",
                          PCL_OPS_VERSION);
  line.addArgument (
      "TRUTH", options.truth_file, "the true planes, .pcd, .ply, .las or text");
  line.addArgument (
      "RESULT", options.result_file, "the planes found, .pcd, .ply, .las or text");
  line.addUpAxis (options.up, "direction against gravity; camera: 0,-1,0 (0,0,1)");
  line.addNumber ("min-plane-points",
                  "N",
                  apps::Range::from (0),
                  options.min_plane_points,
                  "true planes with fewer points count as no plane (1)");
  line.addFlag ("json", options.json, "print JSON instead of a table");
  return line.parse (argc, argv);
}

/** \tparam Size a whole number of points, or a width */
template <typename Size>
nlohmann::ordered_json
jsonOf (const SizeClasses& classes, const char* from)
{
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const SizeClass& size : classes) {
    nlohmann::ordered_json entry{{from, static_cast<Size> (size.from)},
                                 {"below", nullptr},
                                 {"planes", size.planes},
                                 {"found", size.found_50},
                                 {"found_75", size.found_75}};
    if (size.below)
      entry["below"] = static_cast<Size> (*size.below);
    json.push_back (entry);
  }
  return json;
}

void
printJson (const Metrics& metrics)
{
  nlohmann::ordered_json json{{"points", metrics.points},
                              {"truth_planes", metrics.truth_planes},
                              {"result_planes", metrics.result_planes}};
  for (const auto& [name, value] : namedMetrics (metrics))
    json[name] = value;
  json[off_planes_name] = metrics.points_off_planes_called_planes;
  json["by_size"] = jsonOf<std::size_t> (metrics.by_size, "fewest_points");
  json["by_width"] = jsonOf<double> (metrics.by_width, "narrowest");
  std::cout << json.dump (2) << '\n';
}

void
printClasses (const char* title, const SizeClasses& classes)
{
  std::cout << std::left << std::setw (25) << title
            << " number  found at 0.50    0.75\n";
  for (const SizeClass& size : classes)
    std::cout << "  " << std::left << std::setw (20) << size.name() << std::right
              << std::setw (10) << size.planes << std::setw (15) << size.found_50
              << std::setw (8) << size.found_75 << '\n';
}

/** Of the metrics at 0.50 and 0.75, in the order of \ref instance_metrics. */
constexpr const char* titles[] = {"precision",
                                  "recall",
                                  "F-score",
                                  "mean IoU of matched",
                                  "panoptic quality",
                                  "over-segmentation",
                                  "under-segmentation",
                                  "noise",
                                  "missed"};

void
printTable (const Metrics& metrics)
{
  std::cout << metrics.points << " points, " << metrics.truth_planes << " true planes, "
            << metrics.result_planes << " found\n"
            << std::fixed << std::setprecision (2) << "classification accuracy "
            << std::setw (9) << 100.0 * metrics.classification_accuracy << " %\n"
            << "segmentation accuracy   " << std::setw (9)
            << 100.0 * metrics.segmentation_accuracy << " %  of points on true planes\n"
            << "                        " << std::setw (9)
            << 100.0 * metrics.segmentation_accuracy_all << " %  of all points\n"
            << "called planes           " << std::setw (9)
            << 100.0 * metrics.points_off_planes_called_planes
            << " %  of points off true planes\n"
            << std::setprecision (3) << "planes at an overlap of    0.50    0.75\n";
  for (std::size_t i = 0; i < std::size (titles); ++i) {
    const auto value = instance_metrics[i].second;
    std::cout << "  " << std::left << std::setw (20) << titles[i] << std::right
              << std::setw (8) << metrics.at_50.*value << std::setw (8)
              << metrics.at_75.*value << '\n';
  }
  printClasses ("true planes by points", metrics.by_size);
  printClasses ("true planes by width [m]", metrics.by_width);
}

} // namespace

int
compareCommand (int argc, const char* const* argv)
{
  CompareOptions options;
  if (!readOptions (argc, argv, options))
    return apps::ExitCode::done;
  LabeledCloud truth = loadLabeledCloud (options.truth_file);
  const LabeledCloud result = loadLabeledCloud (options.result_file);
  requireSamePoints (truth, result, options.result_file);
  dropSmallPlanes (truth.labels, options.min_plane_points);

  ClassParameters parameters;
  parameters.up = options.up.cast<double>().normalized();
  const Metrics metrics =
      compareLabels (*truth.cloud, truth.labels, result.labels, parameters);
  if (metrics.truth_planes == 0)
    std::cerr << "pcl_ops_evaluate: " << options.truth_file
              << ": has no plane; all that can be right is to find none\n";
  options.json ? printJson (metrics) : printTable (metrics);
  return apps::ExitCode::done;
}

} // namespace pcl_ops::evaluation
