// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tracking.h"

#include <cli/errors.h>
#include <io/pose_file.h>
#include <numbers/angles.h>

namespace pcl_ops::apps {

namespace {

PlaneMatchingParameters
parametersOf (const TrackOptions& options)
{
  PlaneMatchingParameters parameters;
  if (options.rotation_error)
    parameters.rotation_error = toRadians (*options.rotation_error);
  if (options.translation_error)
    parameters.translation_error = *options.translation_error;
  return parameters;
}

std::vector<Eigen::Isometry3d>
posesOf (const TrackOptions& options, std::size_t frames)
{
  if (options.poses.empty())
    return std::vector<Eigen::Isometry3d> (frames, Eigen::Isometry3d::Identity());
  std::vector<Eigen::Isometry3d> poses = loadPoses (options.poses);
  if (poses.size() != frames)
    throw WorkError (options.poses,
                     "has " + std::to_string (poses.size()) + " poses for " +
                         std::to_string (frames) +
                         " clouds; give one for each, in the order of their names");
  return poses;
}

} // namespace

SequenceTracker::SequenceTracker (const TrackOptions& options, std::size_t frames)
: tracker_ (parametersOf (options))
, poses_ (posesOf (options, frames))
, is_finished_ (frames, false)
{}

std::vector<std::uint32_t>
SequenceTracker::idsOf (std::size_t frame,
                        std::vector<PlaneSegment> planes,
                        const Eigen::Vector3d& sensor)
{
  for (PlaneSegment& plane : planes)
    plane.moveBy (-sensor);
  std::unique_lock<std::mutex> lock (mutex_);
  is_next_.wait (lock, [&] { return next_ == frame; });
  return tracker_.track (planes, poses_[frame] * Eigen::Translation3d (sensor));
}

void
SequenceTracker::finish (std::size_t frame)
{
  const std::lock_guard<std::mutex> lock (mutex_);
  is_finished_[frame] = true;
  while (next_ < is_finished_.size() && is_finished_[next_])
    ++next_;
  is_next_.notify_all();
}

} // namespace pcl_ops::apps
