// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "tasks.h"
#include <pcl_ops/plane_tracker.h>

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <vector>

namespace pcl_ops::apps {

/** \brief Numbers for the planes of a sequence of clouds. Its frames may be worked on
 * at the same time; their planes are numbered in their order, so that the numbers are
 * the same for any number of threads. */
class SequenceTracker {
public:
  /** \throws WorkError if the file of poses cannot be read, or has not one for each
   * frame
   */
  SequenceTracker (const TrackOptions& options, std::size_t frames);

  /** \brief The ids of the planes of a frame, once the frames before are done.
   * \param[in] planes in the frame of their cloud
   * \param[in] sensor in that frame: what a pose's error turns about */
  std::vector<std::uint32_t>
  idsOf (std::size_t frame,
         std::vector<PlaneSegment> planes,
         const Eigen::Vector3d& sensor);

  /** \brief An axis of the frame that the poses share, in that of a cloud. */
  Eigen::Vector3f
  inFrame (std::size_t frame, const Eigen::Vector3f& axis) const
  {
    return poses_[frame].rotation().transpose().cast<float>() * axis;
  }

  /** \brief Lets the next frame go on, whatever became of this one. */
  void
  finish (std::size_t frame);

private:
  PlaneTracker tracker_;
  std::vector<Eigen::Isometry3d> poses_;
  std::vector<bool> is_finished_;
  /** \brief The first frame that is not finished. */
  std::size_t next_ = 0;
  std::mutex mutex_;
  std::condition_variable is_next_;
};

} // namespace pcl_ops::apps
