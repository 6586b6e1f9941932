// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "geometry/planar_area.h"
#include <pcl_ops/plane.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

namespace pcl_ops::internal {

/** \brief The bounded part of a plane: a rectangle with the moments of its inliers. */
struct Patch {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  /** \brief Columns, a right-handed frame: unit vectors along the longer and the
   * shorter sides of the rectangle, and its normal, the one of the segment. */
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  /** \brief Half the length, along, and half the width, across [m]. */
  Eigen::Vector2d half_sides = Eigen::Vector2d::Zero();
  /** \brief Mean squared distance of the points to the plane [m^2]. */
  double mean_squared_distance = 0.0;

  Eigen::Vector3d
  normal () const
  {
    return axes.col (2);
  }
  double
  area () const
  {
    return 4.0 * half_sides.prod();
  }
};

/** \brief Returns the rectangle over which evenly spread points have the mean and the
 * variances of the points of a plane.
 * \return nothing for fewer than three points, if all are equal or on one line, or if
 * the normal is not finite */
inline std::optional<Patch>
patchOf (const PlaneSegment& plane)
{
  const std::optional<PlaneFit> fit = fitPlane (plane.moments);
  if (!fit || !plane.normal.allFinite())
    return std::nullopt;
  const Eigen::Matrix3d covariance = plane.moments.covariance();
  // The normal of the segment, not of the fit: it defines the plane that the user has.
  const Eigen::Matrix<double, 3, 2> in_plane = planeAxes (plane.normal);
  const Eigen::Matrix2d spread = in_plane.transpose() * covariance * in_plane;
  // The eigenvector of the larger eigenvalue of the covariance, in closed form.
  const double angle =
      0.5 * std::atan2 (2.0 * spread (0, 1), spread (0, 0) - spread (1, 1));
  const Eigen::Vector2d along (std::cos (angle), std::sin (angle));
  const Eigen::Vector2d across (-along.y(), along.x());
  Patch patch;
  // A tracked plane has moments of several frames, but the centroid of the last frame.
  const Eigen::Vector3d mean = plane.moments.centroid();
  patch.center = mean - plane.normal.dot (mean - plane.centroid) * plane.normal;
  patch.axes << in_plane * along, in_plane * across, plane.normal;
  // Points spread evenly over a side of length 2 h have the variance h^2 / 3.
  patch.half_sides = {std::sqrt (std::max (0.0, 3.0 * along.dot (spread * along))),
                      std::sqrt (std::max (0.0, 3.0 * across.dot (spread * across)))};
  const double rms = plane.rms();
  patch.mean_squared_distance = rms * rms;
  return patch;
}

/** \brief The patch moved by a rigid motion, for instance into another frame. */
inline Patch
moved (const Eigen::Isometry3d& motion, Patch patch)
{
  patch.center = motion * patch.center;
  patch.axes = motion.linear() * patch.axes;
  return patch;
}

/** \brief The plane moved by a rigid motion; its list of inliers is left empty. */
inline PlaneSegment
moved (const Eigen::Isometry3d& motion, const PlaneSegment& plane)
{
  const Eigen::Matrix3d rotation = motion.linear();
  const Moments& moments = plane.moments;
  return {motion * plane.centroid,
          rotation * plane.normal,
          plane.orientation,
          Moments::of (moments.count,
                       motion * moments.centroid(),
                       rotation * moments.covariance() * rotation.transpose()),
          {},
          plane.noise};
}

/** \brief Corners, counter-clockwise seen from the side the normal points to. */
inline std::array<Eigen::Vector3d, 4>
cornersOf (const Patch& patch)
{
  const Eigen::Vector3d along = patch.half_sides.x() * patch.axes.col (0);
  const Eigen::Vector3d across = patch.half_sides.y() * patch.axes.col (1);
  return {patch.center + along + across,
          patch.center - along + across,
          patch.center - along - across,
          patch.center + along - across};
}

/** \brief Returns the part of a convex polygon in the half-plane sign * point[axis] <=
 * bound (Sutherland & Hodgman, "Reentrant polygon clipping", 1974). */
inline std::vector<Eigen::Vector2d>
clipped (const std::vector<Eigen::Vector2d>& polygon,
         Eigen::Index axis,
         double sign,
         double bound)
{
  std::vector<Eigen::Vector2d> inside;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d& from = polygon[i];
    const Eigen::Vector2d& to = polygon[(i + 1) % polygon.size()];
    // Distances of both corners from the bound; positive inside.
    const double from_depth = bound - sign * from[axis];
    const double to_depth = bound - sign * to[axis];
    if (from_depth >= 0.0)
      inside.push_back (from);
    if ((from_depth >= 0.0) != (to_depth >= 0.0))
      inside.push_back (from + from_depth / (from_depth - to_depth) * (to - from));
  }
  return inside;
}

/** \brief Area of the intersection of the first rectangle with the projection of the
 * second onto the plane of the first [m^2]. */
inline double
commonArea (const Patch& first, const Patch& second)
{
  const Eigen::Matrix<double, 3, 2> axes = first.axes.leftCols<2>();
  std::vector<Eigen::Vector2d> corners;
  for (const Eigen::Vector3d& corner : cornersOf (second))
    corners.push_back (axes.transpose() * (corner - first.center));
  for (const Eigen::Index axis : {0, 1})
    for (const double sign : {1.0, -1.0})
      corners = clipped (corners, axis, sign, first.half_sides[axis]);
  // The area is negative if the normals are opposed: the corners then run clockwise.
  return std::abs (areaOf (corners));
}

} // namespace pcl_ops::internal
