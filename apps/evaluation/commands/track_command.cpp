// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "answer.h"
#include "commands.h"
#include <cli/command_line.h>
#include <cli/errors.h>
#include <cli/interruption.h>
#include <cli/program.h>
#include <evaluation/data/labeled_cloud.h>
#include <evaluation/metrics/confusion.h>
#include <io/inputs.h>

#include <filesystem>
#include <map>
#include <set>

namespace pcl_ops::evaluation {

namespace {

struct TrackOptions {
  std::string truth_folder, result_folder;
  std::size_t min_plane_points = 1;
  bool json = false;
};

/** How well the planes of a sequence of clouds keep their numbers. Of true planes those
 * count that are found in two clouds and more: by one plane with more than half of
 * their common points in common. */
struct KeptNumbers {
  struct History {
    std::set<std::uint32_t> numbers;
    std::uint32_t last = 0;
    std::size_t sightings = 0;
  };

  /** By the label of the true plane, which is the same in all clouds. */
  std::map<std::uint32_t, History> histories;
  /** Also of planes that are no true ones. */
  std::set<std::uint32_t> numbers;
  /** Times a true plane is found after the first; times it has the number it had when
   * it was found before. */
  std::size_t sightings = 0, sightings_kept = 0;

  /** Adds the next cloud. */
  void
  add (const PlaneLabels& truth, const PlaneLabels& result)
  {
    const Confusion confusion = confusionOf (truth, result);
    numbers.insert (confusion.result.label.begin(), confusion.result.label.end());
    for (const Overlap& overlap : confusion.overlaps) {
      constexpr double half = 0.5; // above, there is one partner at most
      if (confusion.iou (overlap) <= half)
        continue;
      History& history = histories[confusion.truth.label[overlap.truth]];
      const std::uint32_t number = confusion.result.label[overlap.result];
      sightings += history.sightings > 0;
      sightings_kept += history.sightings > 0 && number == history.last;
      ++history.sightings;
      history.last = number;
      history.numbers.insert (number);
    }
  }
};

bool
readOptions (int argc, const char* const* argv, TrackOptions& options)
{
  apps::CommandLine line (
      "pcl_ops_evaluate track",
      "Tells how many planes keep their number in a sequence of labeled clouds, as\n"
      "pcl_ops_segment --track writes it. The true label of a plane has to be the "
      "same\n"
      "in all clouds, as in those of pcl_ops_simulate --scene walk.",
      PCL_OPS_VERSION);
  line.addArgument ("TRUTH", options.truth_folder, "folder of the true planes");
  line.addArgument (
      "RESULT", options.result_folder, "folder of the planes found, by the same names");
  line.addNumber ("min-plane-points",
                  "N",
                  apps::Range::from (0),
                  options.min_plane_points,
                  "true planes with fewer points in a cloud are not in it (1)");
  line.addFlag ("json", options.json, "print JSON instead of text");
  return line.parse (argc, argv);
}

KeptNumbers
keptIn (const TrackOptions& options)
{
  const apps::InputFiles truth_files = apps::findInputs ({options.truth_folder});
  if (!truth_files.problems.empty())
    throw apps::WorkError ("TRUTH", truth_files.problems.front());
  KeptNumbers kept;
  for (const std::string& file : truth_files.files) {
    apps::stopIfInterrupted();
    const std::string result_file = (std::filesystem::path (options.result_folder) /
                                     std::filesystem::path (file).filename())
                                        .string();
    LabeledCloud truth = loadLabeledCloud (file);
    const LabeledCloud result = loadLabeledCloud (result_file);
    requireSamePoints (truth, result, result_file);
    dropSmallPlanes (truth.labels, options.min_plane_points);
    kept.add (truth.labels, result.labels);
  }
  return kept;
}

Answer
answerOf (const KeptNumbers& kept)
{
  std::size_t planes = 0, planes_kept = 0; // found in two clouds and more
  for (const auto& [label, history] : kept.histories)
    if (history.sightings > 1) {
      ++planes;
      planes_kept += history.numbers.size() == 1 ? 1 : 0;
    }
  return {{"planes", planes},
          {"planes_kept", planes_kept},
          {"sightings", kept.sightings},
          {"sightings_kept", kept.sightings_kept},
          {"numbers", kept.numbers.size()}};
}

} // namespace

int
trackCommand (int argc, const char* const* argv)
{
  TrackOptions options;
  if (!readOptions (argc, argv, options))
    return apps::ExitCode::done;
  print (answerOf (keptIn (options)), options.json);
  return apps::ExitCode::done;
}

} // namespace pcl_ops::evaluation
