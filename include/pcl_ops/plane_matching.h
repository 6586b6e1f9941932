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

/** \brief How much planes of two frames must overlap to be one, and how accurate the
 * given pose between the frames is. */
struct PlaneMatchingParameters {
  /** \brief How far the rotation of the pose is off about any axis, one standard
   * deviation [rad]; default 3 degrees. Errors of three of these, up to 20 degrees in
   * all, are corrected. */
  double rotation_error = 3.0 * (M_PI / 180.0);
  /** \brief The same of its translation along any axis [m]. */
  double translation_error = 0.05;
  /** \brief The smallest share of the smaller of two planes that must lie over the
   * other, 0 to 1. */
  double min_overlap = 0.3;
};

/** \brief What is wrong with parameters, as a sentence; empty if nothing is. */
PCL_OPS_EXPORT std::string
validate (const PlaneMatchingParameters& parameters);

/** \brief Which planes of two frames are one. */
struct PlaneMatches {
  /** \brief For each current plane the position of the previous one that it continues,
   * or \ref no_plane. No previous plane is continued twice. */
  Labels previous;
  /** \brief The pose that was given, moved as little as makes these planes agree. */
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
};

/** \brief Finds the planes of a frame again in the next.
 *
 * Two planes are one if their equations agree and they overlap. Equations agree if what
 * differs, two slopes and a height, lies within three standard deviations of what the
 * pose and both fits may be off; for a fit, that is \ref independentPlaneCovariance
 * without its division by the number of points, as neighboring points err alike. Where
 * a plane ends is known by its moments, as the rectangle that has the same.
 *
 * The larger planes correct the pose first, each by an update of an iterated Kalman
 * filter; then all pairs are looked at with the pose that came of it, the best first:
 * those with the largest product of intersection over union and the root of the
 * likelihood. The sides of a plane are not told apart. The result does not depend on
 * the order of the planes but for ties.
 * \param[in] previous planes of one frame, of which moments and normals are looked at
 * \param[in] current planes of the other frame
 * \param[in] pose the current frame in the previous: a point p of the current frame is
 * pose * p in the previous one. The error of its rotation is about the current frame's
 * zero, which should be the sensor or near it
 * \param[in] parameters of which \ref validate finds nothing wrong
 * \return a match for each current plane; planes whose points span no plane have none
 * \throw std::invalid_argument if there is a problem with the parameters, or the pose
 * is not finite */
PCL_OPS_EXPORT PlaneMatches
matchPlanes (const std::vector<PlaneSegment>& previous,
             const std::vector<PlaneSegment>& current,
             const Eigen::Isometry3d& pose = Eigen::Isometry3d::Identity(),
             const PlaneMatchingParameters& parameters = PlaneMatchingParameters());

} // namespace pcl_ops
