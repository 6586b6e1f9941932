// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Cholesky>

#include "geometry/angles.h"
#include "planes/patch.h"
#include <pcl_ops/plane_detector.h>
#include <pcl_ops/plane_matching.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

namespace pcl_ops {
namespace {

using namespace internal;
using Eigen::Matrix3d;
using Eigen::Vector3d;

using Patches = std::vector<std::optional<Patch>>;

/** \brief Covariance of the errors of a patch: of its slope along, its slope across and
 * its height at the center [m]. It is \ref independentPlaneCovariance without its
 * division by the number of points: neighboring points err alike and surfaces are not
 * quite flat, so that a mean over all points is no better than one of them. */
Matrix3d
covarianceOf (const Patch& patch)
{
  // Height error by rounding to single precision, in units of half the length: that of
  // coordinates up to some 100 times as large, as their error is 6e-8 of them.
  constexpr double rounding = 1e-5;
  const double half_length = patch.half_sides.maxCoeff();
  const double height_variance =
      patch.mean_squared_distance + rounding * rounding * half_length * half_length;
  // Points spread evenly over a side of length 2 h have the variance h^2 / 3.
  const Eigen::Array2d spread = patch.half_sides.array().square() / 3.0;
  return Vector3d (height_variance / spread.x(),
                   height_variance / spread.y(),
                   height_variance)
      .asDiagonal();
}

/** \brief Returns the matrix that turns (slope along, slope across, height) of a plane
 * into the same values for other axes and at another position.
 * \param[in] rotation from the old axes to the new ones
 * \param[in] position coordinates along the old axes [m] */
Matrix3d
transfer (const Eigen::Matrix2d& rotation, const Eigen::Vector2d& position)
{
  Matrix3d result = Matrix3d::Identity();
  result.topLeftCorner<2, 2>() = rotation;
  result.bottomLeftCorner<1, 2>() = position.transpose();
  return result;
}

/** \brief Returns a pose corrected by a motion.
 * \param[in] motion a rotation vector [rad], about the origin of the frame that has the
 * pose, and a shift [m] */
Eigen::Isometry3d
correctedBy (const Eigen::Matrix<double, 6, 1>& motion, Eigen::Isometry3d pose)
{
  const Vector3d rotation = motion.head<3>();
  const double angle = rotation.norm();
  if (angle > 0.0)
    pose.linear() =
        Eigen::AngleAxisd (angle, rotation / angle).toRotationMatrix() * pose.linear();
  pose.translation() += motion.tail<3>();
  return pose;
}

/** \brief How a second patch tilts against a first one, and how high it lies over it.
 */
struct Mismatch {
  /** \brief Slopes along the two axes of the first patch, and the height of the second
   * patch's center over the first patch [m]. */
  Vector3d slopes_and_height;
  /** \brief Covariance of \ref slopes_and_height because of the errors of both patches.
   */
  Matrix3d covariance;
  /** \brief Jacobian of \ref slopes_and_height with respect to a motion of the second
   * patch: a rotation vector [rad] about the origin of its frame, and a shift [m]. */
  Eigen::Matrix<double, 3, 6> by_motion;
};

/** \brief An estimate of the pose of a frame in another one. The covariance is that of
 * its error: a rotation vector [rad] about the origin of the frame and a shift [m],
 * both along the axes of the other frame. */
struct PoseEstimate {
  Eigen::Isometry3d pose;
  Eigen::Matrix<double, 6, 6> covariance;

  PoseEstimate (const Eigen::Isometry3d& given_pose,
                const PlaneMatchingParameters& parameters)
  : pose (given_pose)
  {
    Eigen::Matrix<double, 6, 1> errors; // standard deviations
    errors << Vector3d::Constant (parameters.rotation_error),
        Vector3d::Constant (parameters.translation_error);
    covariance = errors.cwiseAbs2().asDiagonal();
  }

  /** \brief Returns the mismatch of patch \p seen, moved by the pose, against \p fixed.
   * \param[in] fixed patch in the other frame
   * \param[in] seen patch in the frame of the pose; its normal may have either sign */
  Mismatch
  mismatchOf (const Patch& fixed, const Patch& seen) const
  {
    const Patch second = moved (pose, seen);
    const Eigen::Matrix<double, 3, 2> axes = fixed.axes.leftCols<2>();
    const Vector3d normal = fixed.normal();
    const Vector3d between_centers = second.center - fixed.center;
    Mismatch mismatch;
    // The quotient is the same for either sign of the normal.
    const Eigen::Vector2d slopes =
        -axes.transpose() * second.normal() / second.normal().dot (normal);
    mismatch.slopes_and_height << slopes, normal.dot (between_centers);
    // From the errors of each patch to the errors of the slopes and height. Their signs
    // do not matter for the covariance.
    const Matrix3d of_fixed =
        transfer (Eigen::Matrix2d::Identity(), axes.transpose() * between_centers);
    const Matrix3d of_seen = transfer (axes.transpose() * second.axes.leftCols<2>(),
                                       Eigen::Vector2d::Zero());
    mismatch.covariance = of_fixed * covarianceOf (fixed) * of_fixed.transpose() +
                          of_seen * covarianceOf (seen) * of_seen.transpose();
    // A rotation r turns the normal n by r x n, and so the slope along an axis a by
    // -(n x a) . r. It moves the center by r x lever, and so the height by
    // (lever x n) . r.
    const Vector3d lever = second.center - pose.translation();
    mismatch.by_motion.setZero();
    mismatch.by_motion.row (0).head<3>() = -normal.cross (axes.col (0));
    mismatch.by_motion.row (1).head<3>() = -normal.cross (axes.col (1));
    mismatch.by_motion.row (2) << lever.cross (normal).transpose(), normal.transpose();
    return mismatch;
  }

  /** \brief Covariance of the slopes and height because of the errors of both patches
   * and of the pose. */
  Matrix3d
  expectedCovariance (const Mismatch& mismatch) const
  {
    return mismatch.covariance +
           mismatch.by_motion * covariance * mismatch.by_motion.transpose();
  }

  /** \brief Squared Mahalanobis distance of a mismatch: the smaller it is, the better
   * the errors of both patches and of the pose explain the mismatch. */
  double
  squaredDistance (const Mismatch& mismatch) const
  {
    const Vector3d weighted =
        expectedCovariance (mismatch).ldlt().solve (mismatch.slopes_and_height);
    return mismatch.slopes_and_height.dot (weighted);
  }

  /** \brief Corrects the pose by two patches of one plane (the update of an iterated
   * extended Kalman filter). */
  void
  update (const Patch& fixed, const Patch& seen)
  {
    // A rotation by 20 degrees is not linear: repeat the linear update.
    constexpr int iterations = 3; // chosen by hand
    const Eigen::Isometry3d before = pose;
    Eigen::Matrix<double, 6, 1> motion = Eigen::Matrix<double, 6, 1>::Zero();
    Eigen::Matrix<double, 6, 6> removed_covariance;
    for (int i = 0; i < iterations; ++i) {
      const Mismatch mismatch = mismatchOf (fixed, seen);
      const Eigen::Matrix<double, 3, 6>& jacobian = mismatch.by_motion;
      const Eigen::Matrix<double, 6, 3> gain = expectedCovariance (mismatch)
                                                   .ldlt()
                                                   .solve (jacobian * covariance)
                                                   .transpose();
      // The mismatch is that of the pose moved by \ref motion: take it back to the pose
      // before.
      motion = -gain * (mismatch.slopes_and_height - jacobian * motion);
      pose = correctedBy (motion, before);
      removed_covariance = gain * jacobian * covariance;
    }
    covariance -= removed_covariance;
    covariance = 0.5 * (covariance + covariance.transpose()).eval();
  }
};

/** \brief Least absolute cosine between the normals of a pair: at angles above 45
 * degrees slopes are no small errors. */
constexpr double min_cosine = 0.7;

/** \brief Largest \ref PoseEstimate::squaredDistance of a pair: the 99.73 % quantile of
 * the chi-squared distribution with three degrees of freedom. In one dimension three
 * standard deviations contain this share. */
constexpr double max_squared_distance = 14.16;

// Returns for each plane its patch, nothing for planes without one.
Patches
patchesOf (const std::vector<PlaneSegment>& planes)
{
  Patches patches;
  for (const PlaneSegment& plane : planes)
    patches.push_back (patchOf (plane));
  return patches;
}

/** \brief The patches of both frames, and the least overlap for a match. */
struct Frames {
  Patches previous, current;
  /** \brief PlaneMatchingParameters::min_overlap. */
  double min_overlap;
};

/** \brief A plane of the previous frame and one of the current frame that may be one
 * plane. */
struct Pair {
  std::size_t previous, current; // indices of the planes
  /** \brief Intersection over union times the square root of the likelihood, 0 to 1. */
  double score;
};

/** \brief Returns previous plane \p p and current plane \p c as a pair; nothing if they
 * cannot be one plane.
 * \param[in] estimate pose of the current frame in the previous one */
std::optional<Pair>
pairOf (const Frames& frames,
        std::size_t p,
        std::size_t c,
        const PoseEstimate& estimate)
{
  if (!frames.previous[p] || !frames.current[c])
    return std::nullopt;
  const Patch& fixed = *frames.previous[p];
  const Patch& seen = *frames.current[c];
  const Patch moved_patch = moved (estimate.pose, seen);
  if (std::abs (moved_patch.normal().dot (fixed.normal())) < min_cosine)
    return std::nullopt;
  const double squared_distance =
      estimate.squaredDistance (estimate.mismatchOf (fixed, seen));
  if (!(squared_distance <= max_squared_distance))
    return std::nullopt;
  const double common_area = commonArea (fixed, moved_patch);
  constexpr double but_for_rounding = 1.0 - 1e-9;
  const double min_area =
      frames.min_overlap * std::min (fixed.area(), moved_patch.area());
  if (!(common_area > 0.0 && common_area >= but_for_rounding * min_area))
    return std::nullopt;
  const double intersection_over_union =
      common_area / (fixed.area() + moved_patch.area() - common_area);
  // Two frames see different parts of a surface, so that their planes differ by more
  // than noise. So the overlap counts, too, and only the square root of the likelihood
  // exp (-d^2 / 2).
  return Pair{p, c, intersection_over_union * std::exp (-0.25 * squared_distance)};
}

/** \brief Returns the estimate of the pose, corrected by the planes, the largest first:
 * large planes are hardly mistaken for others while the pose is not sure yet. */
PoseEstimate
correctedByPlanes (const Frames& frames, PoseEstimate estimate)
{
  const Patches& previous = frames.previous;
  const Patches& current = frames.current;
  const auto areaOfCurrent = [&] (std::size_t c) {
    return current[c] ? current[c]->area() : 0.0;
  };
  std::vector<std::size_t> by_area (current.size()); // indices of current planes
  std::iota (by_area.begin(), by_area.end(), 0);
  std::stable_sort (
      by_area.begin(), by_area.end(), [&] (std::size_t one, std::size_t other) {
        return areaOfCurrent (one) > areaOfCurrent (other);
      });
  std::vector<bool> is_taken (previous.size(), false); // for each previous plane
  for (const std::size_t c : by_area) {
    std::optional<Pair> best;
    for (std::size_t p = 0; p < previous.size(); ++p) {
      if (is_taken[p])
        continue;
      const std::optional<Pair> pair = pairOf (frames, p, c, estimate);
      if (pair && (!best || pair->score > best->score))
        best = pair;
    }
    if (!best)
      continue;
    is_taken[best->previous] = true;
    estimate.update (*previous[best->previous], *current[c]);
  }
  return estimate;
}

/** \brief Pairs planes greedily, the pair with the largest score first; each plane has
 * one pair at most.
 * \return for each current plane the index of its previous plane, or no_plane */
Labels
oneToOne (const Frames& frames, const PoseEstimate& estimate)
{
  std::vector<Pair> pairs;
  for (std::size_t c = 0; c < frames.current.size(); ++c)
    for (std::size_t p = 0; p < frames.previous.size(); ++p)
      if (const std::optional<Pair> pair = pairOf (frames, p, c, estimate))
        pairs.push_back (*pair);
  std::stable_sort (
      pairs.begin(), pairs.end(), [] (const Pair& one, const Pair& other) {
        return one.score > other.score;
      });
  Labels labels (frames.current.size(), no_plane);
  std::vector<bool> is_taken (frames.previous.size(), false);
  for (const Pair& pair : pairs) {
    if (labels[pair.current] != no_plane || is_taken[pair.previous])
      continue;
    labels[pair.current] = static_cast<std::int32_t> (pair.previous);
    is_taken[pair.previous] = true;
  }
  return labels;
}

} // namespace

std::string
validate (const PlaneMatchingParameters& parameters)
{
  if (!(parameters.rotation_error >= 0.0 &&
        parameters.rotation_error <= max_right_angle))
    return "the rotation error must be between 0 and pi/2 (radians)";
  if (!(parameters.translation_error >= 0.0 &&
        std::isfinite (parameters.translation_error)))
    return "the translation error must be a length from 0";
  if (!(parameters.min_overlap >= 0.0 && parameters.min_overlap <= 1.0))
    return "the smallest overlap must be between 0 and 1";
  return {};
}

PlaneMatches
matchPlanes (const std::vector<PlaneSegment>& previous,
             const std::vector<PlaneSegment>& current,
             const Eigen::Isometry3d& pose,
             const PlaneMatchingParameters& parameters)
{
  detail::throwOn (validate (parameters));
  detail::throwOn (pose.matrix().allFinite() ? "" : "the pose must be finite");
  const Frames frames{
      patchesOf (previous), patchesOf (current), parameters.min_overlap};
  const PoseEstimate estimate =
      correctedByPlanes (frames, PoseEstimate (pose, parameters));
  return {oneToOne (frames, estimate), estimate.pose};
}

} // namespace pcl_ops
