// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_ops/plane_detector.h>
#include <pcl_ops/plane_tracker.h>

#include <algorithm>

namespace pcl_ops {

namespace {

/** \brief How much what was seen before still counts in a new frame: the moments follow
 * the last three frames or so. */
constexpr double kept_share = 0.7;

/** \brief The moments about their centroid, as seen from another frame. */
Moments
moved (const Eigen::Isometry3d& motion, const Moments& moments)
{
  return Moments::of (moments.count,
                      motion * moments.centroid(),
                      motion.linear() * moments.covariance() *
                          motion.linear().transpose());
}

/** \brief A plane in the common frame. */
PlaneSegment
moved (const Eigen::Isometry3d& motion, const PlaneSegment& plane)
{
  PlaneSegment result;
  result.centroid = motion * plane.centroid;
  result.normal = motion.linear() * plane.normal;
  result.orientation = plane.orientation;
  result.moments = moved (motion, plane.moments);
  return result;
}

/** \brief Without what rounding has made of a rotation: over frames it would add up. */
Eigen::Isometry3d
rigid (Eigen::Isometry3d motion)
{
  const Eigen::Quaterniond rotation (motion.linear());
  motion.linear() = rotation.normalized().toRotationMatrix();
  return motion;
}

Moments
scaled (double factor, Moments moments)
{
  moments.count *= factor;
  moments.sum *= factor;
  for (double& product : moments.products)
    product *= factor;
  return moments;
}

/** \brief The plane as it is seen now, as far as it reached before, too. */
void
renew (PlaneSegment& known, const PlaneSegment& seen)
{
  Moments moments = scaled (kept_share, known.moments);
  moments += seen.moments;
  known = seen;
  known.moments = moments.about (seen.centroid);
}

} // namespace

PlaneTracker::PlaneTracker (const PlaneMatchingParameters& parameters,
                            std::optional<std::size_t> memory)
: parameters_ (parameters), memory_ (memory)
{
  detail::throwOn (validate (parameters));
}

std::vector<std::uint32_t>
PlaneTracker::track (const std::vector<PlaneSegment>& planes,
                     const Eigen::Isometry3d& pose)
{
  const Eigen::Isometry3d expected =
      rigid (frames_ == 0 ? pose : pose_ * given_pose_.inverse() * pose);
  std::vector<PlaneSegment> known;
  for (const TrackedPlane& tracked : remembered_)
    known.push_back (tracked.plane);
  const PlaneMatches matches = matchPlanes (known, planes, expected, parameters_);
  pose_ = matches.pose;
  given_pose_ = pose;
  std::vector<std::uint32_t> numbers;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const PlaneSegment seen = moved (pose_, planes[i]);
    const std::int32_t match = matches.previous[i];
    if (match == no_plane) {
      remembered_.push_back ({++last_number_, seen, frames_});
      numbers.push_back (last_number_);
      continue;
    }
    TrackedPlane& tracked = remembered_[static_cast<std::size_t> (match)];
    renew (tracked.plane, seen);
    tracked.last_seen = frames_;
    numbers.push_back (tracked.number);
  }
  const auto is_forgotten = [&] (const TrackedPlane& tracked) {
    return memory_ && frames_ - tracked.last_seen > *memory_;
  };
  remembered_.erase (
      std::remove_if (remembered_.begin(), remembered_.end(), is_forgotten),
      remembered_.end());
  ++frames_;
  return numbers;
}

} // namespace pcl_ops
