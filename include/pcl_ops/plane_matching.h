// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include <pcl_ops/export.h>
#include <pcl_ops/plane.h>

#include <cmath>
#include <string>
#include <vector>

namespace pcl_ops {

/** \brief The overlap that matched planes of two frames need, and the accuracy of the
 * given pose between the frames. */
struct PlaneMatchingParameters {
  /** \brief Standard deviation of the error of the pose's rotation about each axis
   * [rad]; by default 3 degrees. Errors of up to three standard deviations, but at most
   * 20 degrees, are corrected. */
  double rotation_error = 3.0 * (M_PI / 180.0);
  /** \brief Standard deviation of the error of the pose's translation along each axis
   * [m]. */
  double translation_error = 0.05;
  /** \brief Smallest overlap of two matched planes, as a share of the area of the
   * smaller one, 0 to 1. */
  double min_overlap = 0.3;
};

/** \brief Returns the first problem of the parameters; empty if they are valid. */
PCL_OPS_EXPORT std::string
validate (const PlaneMatchingParameters& parameters);

/** \brief Matches between the planes of two frames, and the corrected pose. */
struct PlaneMatches {
  /** \brief For each current plane, the index of the previous plane it matches, or \ref
   * no_plane. Each previous plane has at most one match. */
  Labels previous;
  /** \brief The given pose, corrected by the matched planes. Its alignment does not
   * depend on options of the compiler, such as -mavx2, as that of Eigen's types does.
   */
  alignas (64) Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
};

/** \brief Matches the planes of a frame with the planes of the frame before.
 *
 * Two planes match if their equations agree and they overlap. Equations agree if the
 * differences, two slopes and a height, are within three standard deviations of the
 * errors of the pose and of both plane fits. The errors of a fit are those of \ref
 * independentPlaneCovariance without its division by the number of points, because
 * neighboring points have similar errors. The extent of a plane is the rectangle with
 * the moments of the plane.
 *
 * First the planes correct the pose, the largest plane first, each by an update of an
 * iterated extended Kalman filter. Then all pairs are tested with the corrected pose
 * and matched greedily. The best pair has the largest product of intersection over
 * union and the square root of the likelihood. The sign of normals does not matter. The
 * result does not depend on the order of the planes except for ties.
 * \param[in] previous planes of one frame; only their centroids, moments and normals
 * are used
 * \param[in] current planes of the other frame
 * \param[in] pose of the current frame in the previous frame: a point p of the current
 * frame is pose * p in the previous frame. Its rotation error is about the origin of
 * the current frame, which should be at or near the sensor
 * \param[in] parameters must be valid (\ref validate)
 * \return a match for each current plane; planes whose points span no plane have none
 * \throw std::invalid_argument if the parameters are wrong or the pose is not finite */
PCL_OPS_EXPORT PlaneMatches
matchPlanes (const std::vector<PlaneSegment>& previous,
             const std::vector<PlaneSegment>& current,
             const Eigen::Isometry3d& pose = Eigen::Isometry3d::Identity(),
             const PlaneMatchingParameters& parameters = PlaneMatchingParameters());

} // namespace pcl_ops
