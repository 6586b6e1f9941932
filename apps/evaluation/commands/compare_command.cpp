// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "answer.h"
#include "commands.h"
#include <cli/command_line.h>
#include <cli/program.h>
#include <evaluation/data/labeled_cloud.h>
#include <evaluation/metrics/metrics.h>

#include <iostream>

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
  line.addFlag ("json", options.json, "print JSON instead of text");
  return line.parse (argc, argv);
}

/** \tparam Size a whole number of points, or a width */
template <typename Size>
Answer
answerOf (const SizeClasses& classes, const char* from)
{
  Answer list = Answer::array();
  for (const SizeClass& size : classes) {
    Answer entry{{from, static_cast<Size> (size.from)},
                 {"below", nullptr},
                 {"planes", size.planes},
                 {"found", size.found_50},
                 {"found_75", size.found_75}};
    if (size.below)
      entry["below"] = static_cast<Size> (*size.below);
    list.push_back (entry);
  }
  return list;
}

Answer
answerOf (const Metrics& metrics)
{
  Answer answer{{"points", metrics.points},
                {"truth_planes", metrics.truth_planes},
                {"result_planes", metrics.result_planes}};
  for (const auto& [name, value] : metrics.named)
    answer[name] = value;
  answer[off_planes_name] = metrics.points_off_planes_called_planes;
  answer["by_size"] = answerOf<std::size_t> (metrics.by_size, "fewest_points");
  answer["by_width"] = answerOf<double> (metrics.by_width, "narrowest");
  return answer;
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
  print (answerOf (metrics), options.json);
  return apps::ExitCode::done;
}

} // namespace pcl_ops::evaluation
