// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "commands.h"
#include <cli/command_line.h>
#include <cli/errors.h>
#include <cli/program.h>
#include <evaluation/data/labeled_cloud.h>
#include <evaluation/metrics/confusion.h>
#include <evaluation/report/answer.h>
#include <io/inputs.h>
#include <io/pose_file.h>
#include <numbers/statistics.h>

#include <filesystem>
#include <map>
#include <optional>
#include <set>

namespace pcl_ops::evaluation {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/** A plane as one cloud of a sequence shows it, in the common frame. */
struct PlaneSighting {
  Vector3d centroid, normal;
  PlaneCovariance covariance;
};

/** \param[in] pose from the cloud's frame to the common one
 * \return nothing for planes without a covariance */
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
  /** How far sightings that keep their number differ from the one before, over what
   * their covariances allow: absolute values with a median of 0.67 and 90 % below 1.64
   * if covariances are right and errors have a normal distribution. Of the height of
   * the second's centroid over the first, and of the slopes along both axes of it. */
  std::vector<double> offset_errors, tilt_errors;

  /** Adds the next cloud. \param[in] pose for the errors; not given: none */
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
    // Heights a + b s + c t of the first where the second's centroid is; slopes of the
    // second along the axes of the first, its height along the normal of the first.
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

/** \param[in] poses_file empty: none */
KeptNumbers
keptIn (const std::string& truth_folder,
        const std::string& result_folder,
        const std::string& poses_file,
        std::size_t min_plane_points)
{
  const apps::InputFiles truth_files = apps::findInputs ({truth_folder});
  if (!truth_files.problems.empty())
    throw apps::WorkError ("TRUTH", truth_files.problems.front());
  std::vector<Eigen::Isometry3d> poses;
  if (!poses_file.empty())
    poses = apps::loadPoses (poses_file);
  if (!poses.empty() && poses.size() != truth_files.files.size())
    throw apps::WorkError (poses_file,
                           "has " + std::to_string (poses.size()) + " poses for " +
                               std::to_string (truth_files.files.size()) + " clouds");
  KeptNumbers kept;
  for (std::size_t i = 0; i < truth_files.files.size(); ++i) {
    namespace fs = std::filesystem;
    const std::string& file = truth_files.files[i];
    apps::stopIfInterrupted();
    const std::string result_file =
        (fs::path (result_folder) / fs::path (file).filename()).string();
    const auto [truth, result] =
        loadLabeledClouds (file, result_file, min_plane_points);
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
  if (!kept.offset_errors.empty())
    for (const auto& [name, errors] : {std::pair ("offset_errors", kept.offset_errors),
                                       {"tilt_errors", kept.tilt_errors}}) {
      answer[std::string (name) + "_median"] = apps::quantile (errors, 0.5);
      answer[std::string (name) + "_90"] = apps::quantile (errors, 0.9);
    }
  return answer;
}

} // namespace

int
trackCommand (int argc, const char* const* argv)
{
  std::string truth_folder, result_folder, poses;
  std::size_t min_plane_points = 1;
  bool json = false;
  apps::CommandLine line (
      "pcl_ops_evaluate track",
      "Tells how many planes keep their number in a sequence of labeled clouds, as\n"
      "pcl_ops_segment --track writes it. The true label of a plane has to be the "
      "same\n"
      "in all clouds, as in those of pcl_ops_simulate --scene walk or drive.",
      PCL_OPS_VERSION);
  line.addArgument ("TRUTH", truth_folder, "folder of the true planes");
  line.addArgument (
      "RESULT", result_folder, "folder of the planes found, by the same names");
  line.addNumber ("min-plane-points",
                  "N",
                  apps::Range::from (0),
                  min_plane_points,
                  "true planes with fewer points in a cloud are not in it (1)");
  line.addText (
      "poses",
      "FILE",
      poses,
      "true poses of the sensor, one line per cloud: tells how planes differ\n"
      "from cloud to cloud over what planeCovariance allows");
  line.addFlag ("json", json, "print JSON instead of text");
  if (line.parse (argc, argv))
    print (answerOf (keptIn (truth_folder, result_folder, poses, min_plane_points)),
           json);
  return apps::ExitCode::done;
}

} // namespace pcl_ops::evaluation
