// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause

// The commands that compare labeled clouds with their truth: compare, and track for
// sequences of clouds.
#include "answer.h"
#include "commands.h"
#include "labeled_clouds.h"
#include <cli/command_line.h>
#include <cli/errors.h>
#include <cli/program.h>
#include <io/inputs.h>
#include <io/pose_file.h>
#include <numbers/statistics.h>

#include <filesystem>
#include <map>
#include <set>

namespace pcl_ops::evaluation {

using namespace apps;

namespace {

using Eigen::Matrix3d;

/** \tparam Size type of the size: a whole number of points, or a width [m] */
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
  answer["by_size"] = answerOf<std::size_t> (metrics.by_size, "fewest_points");
  answer["by_width"] = answerOf<double> (metrics.by_width, "narrowest");
  return answer;
}

/** A plane as fitted in one cloud of a sequence, in the common frame of the poses. */
struct PlaneSighting {
  Vector3d centroid, normal;
  PlaneCovariance covariance;
};

std::optional<PlaneSighting>
sightingOf (const XyzCloud& cloud,
            const PlaneSegment& plane,
            const Eigen::Isometry3d& pose)
{
  std::optional<PlaneCovariance> covariance = planeCovariance (cloud, plane);
  if (!covariance)
    return std::nullopt;
  covariance->axes = pose.linear() * covariance->axes;
  return PlaneSighting{
      pose * plane.centroid, pose.linear() * plane.normal, *covariance};
}

/** Counts how often found planes keep their number. A true plane is found in a cloud if
 * a found plane has an intersection over union above 0.5 with it. */
struct KeptNumbers {
  struct History {
    std::set<std::uint32_t> numbers;
    std::uint32_t last = 0;
    std::size_t sightings = 0;
    std::optional<PlaneSighting> seen;
  };

  /** Keys are the labels of true planes. */
  std::map<std::uint32_t, History> histories;
  /** All numbers in the results, also those of planes that match no true plane. */
  std::set<std::uint32_t> numbers;
  /** How often a true plane is found again, and how often with the number it had at its
   * last sighting. */
  std::size_t sightings = 0, sightings_kept = 0;
  /** Differences between two successive sightings with the same number, as absolute
   * values divided by their standard deviations. If covariances are right and errors
   * have a normal distribution, the median is 0.67 and 90 % are below 1.64. Offset: the
   * height of the second centroid over the first plane. Tilt: the slopes of the second
   * plane along both axes of the first. */
  std::vector<double> offset_errors, tilt_errors;

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
      constexpr double half = 0.5; // above it a plane has at most one partner
      if (confusion.iou (overlap) <= half)
        continue;
      History& history = histories[confusion.truth.label[overlap.truth]];
      const std::uint32_t number = confusion.result.label[overlap.result];
      const bool keeps_number = history.sightings > 0 && number == history.last;
      if (history.sightings > 0)
        ++sightings;
      if (keeps_number)
        ++sightings_kept;
      ++history.sightings;
      history.last = number;
      history.numbers.insert (number);
      if (!pose)
        continue;
      const auto seen = sightingOf (*result.cloud, planes[overlap.result], *pose);
      if (keeps_number && seen && history.seen)
        addErrors (*history.seen, *seen);
      history.seen = seen;
    }
  }

  void
  addErrors (const PlaneSighting& first, const PlaneSighting& second)
  {
    const Eigen::Matrix<double, 3, 2>& axes = first.covariance.axes;
    const Vector3d between = second.centroid - first.centroid;
    const double cosine = second.normal.dot (first.normal);
    const Eigen::Vector2d slopes = -axes.transpose() * second.normal / cosine;
    // Errors (slope along u, slope along v, offset), u and v the axes of the first
    // plane. Its errors are moved to the second centroid; those of the second plane are
    // turned to u and v.
    Matrix3d of_first = Matrix3d::Identity();
    of_first.bottomLeftCorner<1, 2>() = (axes.transpose() * between).transpose();
    Matrix3d of_second = Matrix3d::Identity();
    of_second.topLeftCorner<2, 2>() = axes.transpose() * second.covariance.axes;
    const Matrix3d covariance =
        of_first * first.covariance.matrix * of_first.transpose() +
        of_second * second.covariance.matrix * of_second.transpose();
    const Vector3d sigmas = covariance.diagonal().cwiseSqrt();
    for (const Eigen::Index axis : {0, 1})
      tilt_errors.push_back (std::abs (slopes[axis]) / sigmas[axis]);
    offset_errors.push_back (std::abs (first.normal.dot (between)) / sigmas[2]);
  }
};

KeptNumbers
keptIn (const std::string& truth_folder,
        const std::filesystem::path& result_folder,
        const std::string& poses_file,
        std::size_t min_points)
{
  const auto [files, problems] = findInputs ({truth_folder});
  if (!problems.empty())
    throw WorkError ("TRUTH", problems.front());
  std::vector<Eigen::Isometry3d> poses;
  if (!poses_file.empty())
    poses = loadPoses (poses_file);
  if (!poses.empty() && poses.size() != files.size())
    throw WorkError (poses_file,
                     "has " + std::to_string (poses.size()) + " poses for " +
                         std::to_string (files.size()) + " clouds");
  KeptNumbers kept;
  for (std::size_t i = 0; i < files.size(); ++i) {
    stopIfInterrupted();
    const auto name = std::filesystem::path (files[i]).filename();
    const auto [truth, result] =
        loadLabeledClouds (files[i], (result_folder / name).string(), min_points);
    std::optional<Eigen::Isometry3d> pose;
    if (!poses.empty())
      pose = poses[i] * Eigen::Translation3d (result.shift);
    kept.add (truth.labels, result, pose);
  }
  return kept;
}

Answer
answerOf (const KeptNumbers& kept)
{
  std::size_t planes = 0; // found in at least two clouds
  std::size_t planes_kept = 0;
  for (const auto& [label, history] : kept.histories) {
    if (history.sightings < 2)
      continue;
    ++planes;
    if (history.numbers.size() == 1)
      ++planes_kept;
  }
  Answer answer{{"planes", planes},
                {"planes_kept", planes_kept},
                {"sightings", kept.sightings},
                {"sightings_kept", kept.sightings_kept},
                {"numbers", kept.numbers.size()}};
  if (kept.offset_errors.empty())
    return answer;
  answer["offset_errors_median"] = quantile (kept.offset_errors, 0.5);
  answer["offset_errors_90"] = quantile (kept.offset_errors, 0.9);
  answer["tilt_errors_median"] = quantile (kept.tilt_errors, 0.5);
  answer["tilt_errors_90"] = quantile (kept.tilt_errors, 0.9);
  return answer;
}

} // namespace

int
compareCommand (int argc, const char* const* argv)
{
  std::string truth_file;
  std::string result_file;
  Eigen::Vector3f up = Eigen::Vector3f::UnitZ();
  std::size_t min_points = 1;
  bool json = false;
  CommandLine line ("pcl_ops_evaluate compare",
                    "Compares the planes of two labeled clouds of the same "
                    "points (field label, 0: no plane).",
                    PCL_OPS_VERSION);
  line.addArgument ("TRUTH", truth_file, "the true planes, .pcd, .ply, .las or text");
  line.addArgument (
      "RESULT", result_file, "the planes found, .pcd, .ply, .las or text");
  line.addUpAxis (up).help ("direction against gravity; camera: 0,-1,0 (0,0,1)");
  line.add ("min-plane-points N", min_points, from (0))
      .help ("true planes with fewer points count as no plane (1)");
  line.add ("json", json).help ("print JSON instead of text");
  if (!line.parse (argc, argv))
    return ExitCode::done;
  const auto [truth, result] = loadLabeledClouds (truth_file, result_file, min_points);
  const Metrics metrics = compareLabels (
      *truth.cloud, truth.labels, result.labels, {up.cast<double>().normalized()});
  if (metrics.truth_planes == 0)
    warn (truth_file + ": has no plane; all that can be right is to find none");
  print (answerOf (metrics), json);
  return ExitCode::done;
}

int
trackCommand (int argc, const char* const* argv)
{
  std::string truth_folder;
  std::string result_folder;
  std::string poses;
  std::size_t min_points = 1;
  bool json = false;
  CommandLine line (
      "pcl_ops_evaluate track",
      "Tells how many planes keep their number in a sequence of labeled clouds, as\n"
      "pcl_ops_segment --track writes it. The true label of a plane has to be the "
      "same\n"
      "in all clouds, as in those of pcl_ops_simulate --scene walk or drive.",
      PCL_OPS_VERSION);
  line.addArgument ("TRUTH", truth_folder, "folder of the true planes");
  line.addArgument (
      "RESULT", result_folder, "folder of the planes found, by the same names");
  line.add ("min-plane-points N", min_points, from (0))
      .help ("true planes with fewer points in a cloud are not in it (1)");
  line.add ("poses FILE", poses)
      .help ("true poses of the sensor, one line per cloud: tells how planes differ\n"
             "from cloud to cloud over what planeCovariance allows");
  line.add ("json", json).help ("print JSON instead of text");
  if (line.parse (argc, argv))
    print (answerOf (keptIn (truth_folder, result_folder, poses, min_points)), json);
  return ExitCode::done;
}

} // namespace pcl_ops::evaluation
