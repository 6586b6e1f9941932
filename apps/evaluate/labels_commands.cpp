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

/** Returns an object for each size class, from SizeClass::from up to but without
 * SizeClass::below.
 * \tparam Size type of the size: a whole number of points, or a width [m]
 * \param[in] key_of_from key of SizeClass::from */
template <typename Size>
Answer
answerOf (const SizeClasses& classes, const char* key_of_from)
{
  Answer list = Answer::array();
  for (const SizeClass& size : classes)
    list.push_back ({{key_of_from, Size (size.from)},
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
struct SeenPlane {
  Vector3d centroid, normal;
  PlaneCovariance covariance;
};

/** Returns a plane in the frame of the poses; nothing if it has no covariance.
 * \param[in] plane found in the cloud, in its frame
 * \param[in] pose of the cloud */
std::optional<SeenPlane>
seenPlaneOf (const XyzCloud& cloud,
             const PlaneSegment& plane,
             const Eigen::Isometry3d& pose)
{
  std::optional<PlaneCovariance> covariance = planeCovariance (cloud, plane);
  if (!covariance)
    return std::nullopt;
  covariance->axes = pose.linear() * covariance->axes;
  return SeenPlane{pose * plane.centroid, pose.linear() * plane.normal, *covariance};
}

/** Counts how often found planes keep their number, which is their label in the
 * results. A true plane is found in a cloud if a found plane has an intersection over
 * union above 0.5 with it; it then has the number of that found plane. */
struct KeptNumbers {
  /** A true plane over the sequence of clouds. */
  struct TruePlane {
    /** Number of clouds in which it is found. */
    std::size_t times_found = 0;
    /** All numbers that it had in these clouds. */
    std::set<std::uint32_t> numbers;
    /** Its number in the last cloud in which it was found. */
    std::uint32_t last_number = 0;
    /** The plane as it was found last, if poses and a covariance are known. */
    std::optional<SeenPlane> last_seen;
  };

  /** By the labels of the truth. */
  std::map<std::uint32_t, TruePlane> true_planes;
  /** All numbers in the results, also those of planes that match no true plane. */
  std::set<std::uint32_t> all_numbers;
  /** How often a true plane is found that was found in an earlier cloud. */
  std::size_t found_again = 0;
  /** How often it then has TruePlane::last_number. */
  std::size_t found_again_with_number = 0;
  /** Differences between a plane that is found again with its number (second) and the
   * same plane when it was found last (first): absolute values divided by their
   * standard deviations. If covariances are right and errors have a normal
   * distribution, the median is 0.67 and 90 % are below 1.64. Offset: the height of the
   * second centroid over the first plane. Tilt: the slopes of the second plane along
   * both axes of the first. */
  std::vector<double> offset_errors, tilt_errors;

  /** Adds the next cloud of the sequence.
   * \param[in] pose of the cloud; nothing: errors are not computed */
  void
  add (const PlaneLabels& truth,
       const LabeledCloud& result,
       const std::optional<Eigen::Isometry3d>& pose)
  {
    const Confusion confusion = confusionOf (truth, result.labels);
    const std::vector<PlaneSegment> planes =
        pose ? planesOf (*result.cloud, confusion.result, {})
             : std::vector<PlaneSegment>();
    all_numbers.insert (confusion.result.label.begin(), confusion.result.label.end());
    for (const Overlap& overlap : confusion.overlaps) {
      constexpr double min_iou = 0.5; // above it a plane has at most one partner
      if (confusion.iou (overlap) <= min_iou)
        continue;
      TruePlane& plane = true_planes[confusion.truth.label[overlap.truth]];
      const std::uint32_t number = confusion.result.label[overlap.result];
      const bool is_found_again = plane.times_found > 0;
      const bool keeps_number = is_found_again && number == plane.last_number;
      if (is_found_again)
        ++found_again;
      if (keeps_number)
        ++found_again_with_number;
      ++plane.times_found;
      plane.last_number = number;
      plane.numbers.insert (number);
      if (!pose)
        continue;
      const std::optional<SeenPlane> seen =
          seenPlaneOf (*result.cloud, planes[overlap.result], *pose);
      if (keeps_number && seen && plane.last_seen)
        addErrors (*plane.last_seen, *seen);
      plane.last_seen = seen;
    }
  }

  /** Adds to \ref offset_errors and \ref tilt_errors. */
  void
  addErrors (const SeenPlane& first, const SeenPlane& second)
  {
    const Eigen::Matrix<double, 3, 2>& axes = first.covariance.axes;
    const Vector3d between = second.centroid - first.centroid;
    const double cosine = second.normal.dot (first.normal);
    const Eigen::Vector2d slopes = -axes.transpose() * second.normal / cosine;
    // Errors are (slope along u, slope along v, offset), where u and v are the axes of
    // the first plane. Its errors are taken at the second centroid, and those of the
    // second plane are turned to u and v. C = A1 C1 A1^T + A2 C2 A2^T.
    Matrix3d to_second_centroid = Matrix3d::Identity();
    to_second_centroid.bottomLeftCorner<1, 2>() =
        (axes.transpose() * between).transpose();
    Matrix3d to_first_axes = Matrix3d::Identity();
    to_first_axes.topLeftCorner<2, 2>() = axes.transpose() * second.covariance.axes;
    const Matrix3d covariance =
        to_second_centroid * first.covariance.matrix * to_second_centroid.transpose() +
        to_first_axes * second.covariance.matrix * to_first_axes.transpose();
    const Vector3d sigmas = covariance.diagonal().cwiseSqrt();
    for (const Eigen::Index axis : {0, 1})
      tilt_errors.push_back (std::abs (slopes[axis]) / sigmas[axis]);
    offset_errors.push_back (std::abs (first.normal.dot (between)) / sigmas[2]);
  }
};

/** Compares the clouds of the truth with the results of the same file names.
 * \param[in] poses_file empty: no poses
 * \param[in] min_plane_points points of true planes with fewer points count as on no
 * plane
 * \throws WorkError if a file cannot be read, or does not fit the others */
KeptNumbers
keptNumbersIn (const std::string& truth_folder,
               const std::filesystem::path& result_folder,
               const std::string& poses_file,
               std::size_t min_plane_points)
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
        loadLabeledClouds (files[i], (result_folder / name).string(), min_plane_points);
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
  std::size_t planes_found_again = 0;
  std::size_t planes_with_one_number = 0;
  for (const auto& [label, plane] : kept.true_planes) {
    if (plane.times_found < 2)
      continue;
    ++planes_found_again;
    if (plane.numbers.size() == 1)
      ++planes_with_one_number;
  }
  Answer answer{{"planes", planes_found_again},
                {"planes_kept", planes_with_one_number},
                {"sightings", kept.found_again},
                {"sightings_kept", kept.found_again_with_number},
                {"numbers", kept.all_numbers.size()}};
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
  std::size_t min_plane_points = 1;
  bool prints_json = false;
  CommandLine line ("pcl_ops_evaluate compare",
                    "Compares the planes of two labeled clouds of the same "
                    "points (field label, 0: no plane).",
                    PCL_OPS_VERSION);
  line.addArgument ("TRUTH", truth_file, "the true planes, .pcd, .ply, .las or text");
  line.addArgument (
      "RESULT", result_file, "the planes found, .pcd, .ply, .las or text");
  line.addUpAxis (up).help ("direction against gravity; camera: 0,-1,0 (0,0,1)");
  line.add ("min-plane-points N", min_plane_points, from (0))
      .help ("true planes with fewer points count as no plane (1)");
  line.add ("json", prints_json).help ("print JSON instead of text");
  if (!line.parse (argc, argv))
    return ExitCode::done;
  const auto [truth, result] =
      loadLabeledClouds (truth_file, result_file, min_plane_points);
  const Metrics metrics = compareLabels (
      *truth.cloud, truth.labels, result.labels, {up.cast<double>().normalized()});
  if (metrics.truth_planes == 0)
    warn (truth_file + ": has no plane; all that can be right is to find none");
  print (answerOf (metrics), prints_json);
  return ExitCode::done;
}

int
trackCommand (int argc, const char* const* argv)
{
  std::string truth_folder;
  std::string result_folder;
  std::string poses_file;
  std::size_t min_plane_points = 1;
  bool prints_json = false;
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
  line.add ("min-plane-points N", min_plane_points, from (0))
      .help ("true planes with fewer points in a cloud are not in it (1)");
  line.add ("poses FILE", poses_file)
      .help ("true poses of the sensor, one line per cloud: tells how planes differ\n"
             "from cloud to cloud over what planeCovariance allows");
  line.add ("json", prints_json).help ("print JSON instead of text");
  if (!line.parse (argc, argv))
    return ExitCode::done;
  const KeptNumbers kept =
      keptNumbersIn (truth_folder, result_folder, poses_file, min_plane_points);
  print (answerOf (kept), prints_json);
  return ExitCode::done;
}

} // namespace pcl_ops::evaluation
