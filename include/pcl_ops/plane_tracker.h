// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include <pcl_ops/export.h>
#include <pcl_ops/plane.h>
#include <pcl_ops/plane_extent.h>
#include <pcl_ops/plane_matching.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace pcl_ops {

/** \brief A plane with its number, which is the same in all frames. */
struct TrackedPlane {
  /** \brief Counted from 1, in the order in which planes were first seen. */
  std::uint32_t number = 0;
  /** \brief The plane in the common frame. Its orientation is that of the frame it was
   * last seen in. Its moments are a weighted sum over the frames it was seen in, with
   * the largest weights on the latest: their count is no number of points. It has no
   * inliers. */
  PlaneSegment plane;
  /** \brief Convex hull of the plane in all frames, in the common frame. Each frame
   * adds the rectangle that has the moments of the plane. Holes are not known. */
  PlaneExtent extent;
  /** \brief Number of the first frame it was seen in; frames are numbered from 0. */
  std::size_t first_seen = 0;
  /** \brief Number of the last frame it was seen in. */
  std::size_t last_seen = 0;
  /** \brief The number of frames it was seen in. */
  std::size_t times_seen = 0;
};

/** \brief Tracks planes: gives each plane a number that it keeps from frame to frame,
 * also if it is not seen for a while. Track a frame in a copy to try it. */
class PCL_OPS_EXPORT PlaneTracker {
public:
  /** \param[in] parameters of the matching; the pose errors are those of the motion
   * from one frame to the next
   * \param[in] memory a plane is forgotten once it was not seen in more than this many
   * frames in a row; not given: never
   * \param[in] max_distance planes with all parts farther than this from the sensor are
   * forgotten [m]; above 0; not given: no limit
   * \throw std::invalid_argument if the parameters are wrong */
  explicit PlaneTracker (
      const PlaneMatchingParameters& parameters = PlaneMatchingParameters(),
      std::optional<std::size_t> memory = std::nullopt,
      std::optional<double> max_distance = std::nullopt);

  /** \brief Numbers the planes of the next frame.
   * \param[in] planes the planes that a detector returned, in the sensor's frame
   * \param[in] pose of the sensor in a common frame: a point p has the position pose *
   * p there. Only the motion since the last frame is used, so that poses may drift. If
   * the sensor does not move, all poses are equal
   * \return the number of each plane, all different; planes that were not seen before
   * get new numbers, in the order of \p planes. Planes whose points span none, as
   * points on a line, have no extent by which to know them again (\ref matchPlanes):
   * they get new numbers in each frame, and are forgotten with the next one
   * \throw std::invalid_argument if the pose is not finite */
  std::vector<std::uint32_t>
  track (const std::vector<PlaneSegment>& planes, const Eigen::Isometry3d& pose);

  /** \brief Returns all remembered planes, by ascending number. */
  const std::vector<TrackedPlane>&
  planes () const
  {
    return remembered_;
  }

  /** \brief Returns the pose of the last frame in the common frame, corrected by its
   * planes: planes that are seen again correct drift. */
  const Eigen::Isometry3d&
  pose () const
  {
    return pose_;
  }

private:
  bool
  isForgotten (const TrackedPlane& tracked) const;

  PlaneMatchingParameters parameters_;
  std::optional<std::size_t> memory_;
  std::optional<double> max_distance_;
  std::vector<TrackedPlane> remembered_;
  // Aligned alike for all options of the compiler, as PlaneMatches::pose is.
  alignas (64) Eigen::Isometry3d pose_ = Eigen::Isometry3d::Identity();
  /** \brief The uncorrected pose of the last frame. */
  alignas (64) Eigen::Isometry3d given_pose_ = Eigen::Isometry3d::Identity();
  std::size_t frames_ = 0;        // number of frames so far
  std::uint32_t last_number_ = 0; // of the plane that was first seen last
};

} // namespace pcl_ops
