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
#include <evaluation/report/plane_sighting.h>
#include <io/inputs.h>
#include <io/pose_file.h>
#include <numbers/quantile.h>

#include <filesystem>
#include <map>
#include <optional>
#include <set>

namespace pcl_ops::evaluation {

namespace {

struct TrackOptions {
  std::string truth_folder, result_folder, poses;
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
    std::optional<PlaneSighting> seen;
  };

  /** By the label of the true plane, which is the same in all clouds. */
  std::map<std::uint32_t, History> histories;
  /** Also of planes that are no true ones. */
  std::set<std::uint32_t> numbers;
  /** Times a true plane is found after the first; times it has the number it had when
   * it was found before. */
  std::size_t sightings = 0, sightings_kept = 0;
  /** Of sightings that keep their number, each with the one before. */
  NormalizedErrors errors;

  /** Adds the next cloud. \param[in] pose for \ref errors; not given: none */
  void
  add (const PlaneLabels& truth,
       const LabeledCloud& result,
       const std::optional<Eigen::Isometry3d>& pose)
  {
    const Confusion confusion = confusionOf (truth, result.labels);
    const auto planes = pose ? planesOf (*result.cloud, confusion.result, {})
                             : std::vector<PlaneSegment>();
    numbers.insert (confusion.result.label.begin(), confusion.result.label.end());
    for (const Overlap& overlap : confusion.overlaps) {
      constexpr double half = 0.5; // above, there is one partner at most
      if (confusion.iou (overlap) <= half)
        continue;
      History& history = histories[confusion.truth.label[overlap.truth]];
      const std::uint32_t number = confusion.result.label[overlap.result];
      const bool keeps_number = history.sightings > 0 && number == history.last;
      sightings += history.sightings > 0;
      sightings_kept += keeps_number;
      ++history.sightings;
      history.last = number;
      history.numbers.insert (number);
      if (!pose)
        continue;
      const auto seen = sightingOf (*result.cloud, planes[overlap.result], *pose);
      if (keeps_number && seen && history.seen)
        errors.add (*history.seen, *seen);
      history.seen = seen;
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
  line.addText (
      "poses",
      "FILE",
      options.poses,
      "true poses of the sensor, one line per cloud: tells how planes differ\n"
      "from cloud to cloud over what planeCovariance allows");
  line.addFlag ("json", options.json, "print JSON instead of text");
  return line.parse (argc, argv);
}

KeptNumbers
keptIn (const TrackOptions& options)
{
  const apps::InputFiles truth_files = apps::findInputs ({options.truth_folder});
  if (!truth_files.problems.empty())
    throw apps::WorkError ("TRUTH", truth_files.problems.front());
  std::vector<Eigen::Isometry3d> poses;
  if (!options.poses.empty())
    poses = apps::loadPoses (options.poses);
  if (!poses.empty() && poses.size() != truth_files.files.size())
    throw apps::WorkError (options.poses,
                           "has " + std::to_string (poses.size()) + " poses for " +
                               std::to_string (truth_files.files.size()) + " clouds");
  KeptNumbers kept;
  for (std::size_t i = 0; i < truth_files.files.size(); ++i) {
    const std::string& file = truth_files.files[i];
    apps::stopIfInterrupted();
    const std::string result_file = (std::filesystem::path (options.result_folder) /
                                     std::filesystem::path (file).filename())
                                        .string();
    LabeledCloud truth = loadLabeledCloud (file);
    const LabeledCloud result = loadLabeledCloud (result_file);
    requireSamePoints (truth, result, result_file);
    dropSmallPlanes (truth.labels, options.min_plane_points);
    kept.add (truth.labels,
              result,
              poses.empty() ? std::nullopt
                            : std::make_optional<Eigen::Isometry3d> (
                                  poses[i] * Eigen::Translation3d (result.shift)));
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
  Answer answer{{"planes", planes},
                {"planes_kept", planes_kept},
                {"sightings", kept.sightings},
                {"sightings_kept", kept.sightings_kept},
                {"numbers", kept.numbers.size()}};
  if (kept.errors.offsets.empty())
    return answer;
  for (const auto& [name, errors] : {std::pair ("offset_errors", kept.errors.offsets),
                                     {"tilt_errors", kept.errors.tilts}}) {
    answer[std::string (name) + "_median"] = apps::quantile (errors, 0.5);
    answer[std::string (name) + "_90"] = apps::quantile (errors, 0.9);
  }
  return answer;
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
