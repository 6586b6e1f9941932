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

/** \brief A plane with the number it has in all frames. */
struct TrackedPlane {
  /** \brief From 1, in the order of appearance. */
  std::uint32_t number = 0;
  /** \brief In the common frame, without inliers; its orientation is that by the up
   * axis of the last frame. Its moments are a sum over the frames it was seen in, in
   * which the last ones count most: their count is no number of points. */
  PlaneSegment plane;
  /** \brief Where it was seen in any frame: the convex outline around the rectangles
   * that have the moments of each frame; nothing is known of holes. */
  PlaneExtent extent;
  /** \brief The first and the last frame it was seen in, from 0. */
  std::size_t first_seen = 0;
  std::size_t last_seen = 0;
  /** \brief The number of frames it was seen in. */
  std::size_t times_seen = 0;
};

/** \brief Numbers for planes that they keep from frame to frame, also where they are
 * out of sight for a while. Copy it to try what a frame would do. */
class PCL_OPS_EXPORT PlaneTracker {
public:
  /** \param[in] parameters of the poses; errors are those from one frame to the next
   * \param[in] memory frames a plane is remembered after it was last seen; not given:
   * for ever
   * \param[in] max_distance planes of which every part is farther from the sensor are
   * forgotten [m]; not given: none
   * \throw std::invalid_argument if there is a problem with the parameters */
  explicit PlaneTracker (
      const PlaneMatchingParameters& parameters = PlaneMatchingParameters(),
      std::optional<std::size_t> memory = std::nullopt,
      std::optional<double> max_distance = std::nullopt);

  /** \brief Numbers the planes of the next frame.
   * \param[in] planes as a detector gives them, in the frame's own coordinates
   * \param[in] pose the frame in a common one: a point p of the frame is pose * p
   * there. Only how it moved since the frame before counts, so that poses may drift;
   * the same for all frames if the sensor stands still
   * \return the number of each plane, all different; planes that were not seen before
   * get new ones, in their order
   * \throw std::invalid_argument if the pose is not finite */
  std::vector<std::uint32_t>
  track (const std::vector<PlaneSegment>& planes, const Eigen::Isometry3d& pose);

  /** \brief All planes that are remembered, by their numbers. */
  const std::vector<TrackedPlane>&
  planes () const
  {
    return remembered_;
  }

  /** \brief The last frame in the common one, as its planes say: drift is corrected
   * where planes are seen again. */
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
  Eigen::Isometry3d pose_ = Eigen::Isometry3d::Identity();
  /** \brief As it was given for the last frame. */
  Eigen::Isometry3d given_pose_ = Eigen::Isometry3d::Identity();
  std::size_t frames_ = 0;
  std::uint32_t last_number_ = 0;
};

} // namespace pcl_ops
