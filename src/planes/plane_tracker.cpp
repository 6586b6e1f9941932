// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planes/patch.h"
#include <pcl_ops/plane_detector.h>
#include <pcl_ops/plane_tracker.h>

#include <algorithm>
#include <cmath>

namespace pcl_ops {
namespace {

/** \brief Factor of the older moments in each frame that sees the plane; chosen by
 * hand. The weights of all frames sum up to at most 1 / (1 - 0.7), the weight of about
 * three new frames. */
constexpr double weight_of_older = 0.7;

/** \brief Returns a motion with its rotation normalized: rounding would add up over
 * frames. */
Eigen::Isometry3d
normalized (Eigen::Isometry3d motion)
{
  const Eigen::Quaterniond rotation (motion.linear());
  motion.linear() = rotation.normalized().toRotationMatrix();
  return motion;
}

/** \brief Replaces a known plane by the plane seen now, with the moments of both: older
 * moments count less. */
void
update (PlaneSegment& known, const PlaneSegment& seen)
{
  Moments moments = known.moments;
  moments.count *= weight_of_older;
  moments.sum *= weight_of_older;
  for (double& product : moments.products)
    product *= weight_of_older;
  moments += seen.moments;
  known = seen;
  known.moments = moments.about (seen.centroid);
}

/** \brief Extends an outline to the convex hull of itself and the rectangle seen now,
 * both projected onto the plane seen now. */
void
widen (PlaneExtent& extent, const PlaneSegment& seen)
{
  const std::optional<internal::Patch> patch = internal::patchOf (seen);
  if (!patch)
    return;
  const PlaneFrame frame (seen.centroid, seen.normal);
  PlanarPoints corners;
  for (const Eigen::Vector3d& corner : extent.hull)
    corners.push_back (frame.toPlane (corner));
  for (const Eigen::Vector3d& corner : internal::cornersOf (*patch))
    corners.push_back (frame.toPlane (corner));
  constexpr double none_outside = 0.0; // share of the corners
  extent = extentOf ({convexHull (corners, none_outside)}, corners, frame);
}

} // namespace

PlaneTracker::PlaneTracker (const PlaneMatchingParameters& parameters,
                            std::optional<std::size_t> memory,
                            std::optional<double> max_distance)
: parameters_ (parameters), memory_ (memory), max_distance_ (max_distance)
{
  detail::throwOn (validate (parameters));
  detail::throwOn (!max_distance || *max_distance > 0.0
                       ? ""
                       : "the largest distance must be a length above 0");
}

bool
PlaneTracker::isForgotten (const TrackedPlane& tracked) const
{
  // No frame can match it: it would be known forever, and new in each frame.
  if (tracked.last_seen < frames_ && !internal::patchOf (tracked.plane))
    return true;
  if (memory_ && frames_ - tracked.last_seen > *memory_)
    return true;
  if (!max_distance_ || tracked.extent.hull.empty())
    return false;
  // Radius of the circle around the smallest rectangle of the outline.
  const double radius = 0.5 * std::hypot (tracked.extent.length, tracked.extent.width);
  const double to_center = (tracked.extent.center - pose_.translation()).norm();
  return to_center - radius > *max_distance_;
}

std::vector<std::uint32_t>
PlaneTracker::track (const std::vector<PlaneSegment>& planes,
                     const Eigen::Isometry3d& pose)
{
  const Eigen::Isometry3d expected =
      normalized (frames_ == 0 ? pose : pose_ * given_pose_.inverse() * pose);
  std::vector<PlaneSegment> known;
  for (const TrackedPlane& tracked : remembered_)
    known.push_back (tracked.plane);
  const PlaneMatches matches = matchPlanes (known, planes, expected, parameters_);
  pose_ = matches.pose;
  given_pose_ = pose;
  std::vector<std::uint32_t> numbers;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const PlaneSegment seen = internal::moved (pose_, planes[i]);
    const bool is_new = matches.previous[i] == no_plane;
    if (is_new)
      remembered_.push_back ({++last_number_, seen, {}, frames_});
    TrackedPlane& tracked =
        is_new ? remembered_.back()
               : remembered_[static_cast<std::size_t> (matches.previous[i])];
    if (!is_new)
      update (tracked.plane, seen);
    widen (tracked.extent, seen);
    tracked.last_seen = frames_;
    ++tracked.times_seen;
    numbers.push_back (tracked.number);
  }
  remembered_.erase (std::remove_if (remembered_.begin(),
                                     remembered_.end(),
                                     [this] (const TrackedPlane& tracked) {
                                       return isForgotten (tracked);
                                     }),
                     remembered_.end());
  ++frames_;
  return numbers;
}

} // namespace pcl_ops
