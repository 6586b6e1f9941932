// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "commands.h"
#include <cli/command_line.h>
#include <cli/program.h>
#include <evaluation/data/labeled_cloud.h>
#include <evaluation/metrics/metrics.h>
#include <evaluation/report/answer.h>

namespace pcl_ops::evaluation {

namespace {

/** \tparam Size a whole number of points, or a width */
template <typename Size>
Answer
answerOf (const SizeClasses& classes, const char* from)
{
  Answer list = Answer::array();
  for (const SizeClass& size : classes)
    list.push_back ({{from, Size (size.from)},
                     {"below", size.below ? Answer (Size (*size.below)) : Answer()},
                     {"planes", size.planes},
                     {"found", size.found_50},
                     {"found_75", size.found_75}});
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
  std::string truth_file, result_file;
  Eigen::Vector3f up = Eigen::Vector3f::UnitZ();
  std::size_t min_plane_points = 1;
  bool json = false;
  apps::CommandLine line ("pcl_ops_evaluate compare",
                          "Compares the planes of two labeled clouds of the same "
                          "points (field label, 0: no plane).",
                          PCL_OPS_VERSION);
  line.addArgument ("TRUTH", truth_file, "the true planes, .pcd, .ply, .las or text");
  line.addArgument (
      "RESULT", result_file, "the planes found, .pcd, .ply, .las or text");
  line.addUpAxis (up, "direction against gravity; camera: 0,-1,0 (0,0,1)");
  line.addNumber ("min-plane-points",
                  "N",
                  apps::Range::from (0),
                  min_plane_points,
                  "true planes with fewer points count as no plane (1)");
  line.addFlag ("json", json, "print JSON instead of text");
  if (!line.parse (argc, argv))
    return apps::ExitCode::done;
  const auto [truth, result] =
      loadLabeledClouds (truth_file, result_file, min_plane_points);
  const Metrics metrics = compareLabels (
      *truth.cloud, truth.labels, result.labels, {up.cast<double>().normalized()});
  if (metrics.truth_planes == 0)
    apps::warn (truth_file + ": has no plane; all that can be right is to find none");
  print (answerOf (metrics), json);
  return apps::ExitCode::done;
}

} // namespace pcl_ops::evaluation
