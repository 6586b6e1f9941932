// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <pcl_ops/export.h>
#include <pcl_ops/plane.h>

#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace pcl_ops {

/** \brief Parameters of \ref regularizePlanes. Lengths are in the unit of the planes.
 * The defaults are chosen by hand. */
struct PlaneRegularizationParameters {
  /** \brief Planes become parallel or orthogonal if their angle differs by at most this
   * from 0 or pi/2 [rad]; by default 3 degrees. */
  double max_angle = 3.0 * (M_PI / 180.0);
  /** \brief Parallel planes become coplanar if they are within this distance [unit of
   * the planes]. Not given: 3 sqrt (rms1^2 + rms2^2). */
  std::optional<double> max_offset;
  /** \brief Largest displacement of a plane. The displacement is the rms change of the
   * distances of its inliers to it, over their rms distance to it before the move: it
   * has no unit. A larger move is not made; so a plane of rms 0 never moves, and
   * neither does one without points. The covariance of a plane with n inliers is rms^2
   * (A^T A)^-1 (\ref independentPlaneCovariance). So a displacement of 1 is sqrt (n)
   * standard deviations. */
  double max_displacement = 1.0;
};

/** \brief Returns the first problem of the parameters; empty if they are valid. */
PCL_OPS_EXPORT std::string
validate (const PlaneRegularizationParameters& parameters);

/** \brief The move of a plane. */
struct PlaneMove {
  /** \brief The plane is rotated about its centroid by angle [rad], then shifted along
   * its new normal by offset [unit of the planes]. */
  double angle = 0.0;
  double offset = 0.0;
  /** \brief Displacement as in \ref PlaneRegularizationParameters::max_displacement. If
   * the move was too large and so not made, the displacement it would have had. */
  double displacement = 0.0;
  bool is_moved = false;
  /** \brief Planes with equal direction are parallel, planes with equal level are
   * coplanar. A plane that was not regularized has its own number for both. */
  std::size_t direction = 0;
  std::size_t level = 0;
};

/** \brief The result of \ref regularizePlanes. */
struct RegularizedPlanes {
  /** \brief Planes in the order of the input, with new centroids and normals. Inliers
   * and moments are unchanged, so that rms () is about the new plane. */
  std::vector<PlaneSegment> planes;
  std::vector<PlaneMove> moves; // of each plane
};

/** \brief Makes nearly parallel, orthogonal and coplanar planes exactly parallel,
 * orthogonal and coplanar, for example the walls of a building.
 *
 * Groups of planes within max_angle of their largest plane get the mean direction of
 * the group, weighted by points. Then the direction of a group becomes orthogonal to
 * those of larger groups, if it is within max_angle of orthogonal. Planes rotate about
 * their centroids. Parallel planes within max_offset of each other get one offset
 * (after Verdie, Lafarge & Alliez, *LOD generation for urban scenes*, ACM Transactions
 * on Graphics 34, 2015, as CGAL's regularize_planes, without its symmetry about an
 * axis). A plane is not changed, and does not count for the mean direction, if the
 * rotation would exceed max_displacement. If only the common offset would exceed it,
 * the plane is rotated and keeps its own offset.
 * \throw std::invalid_argument if the parameters are wrong, or a centroid or normal is
 * not finite */
PCL_OPS_EXPORT RegularizedPlanes
regularizePlanes (
    const std::vector<PlaneSegment>& planes,
    const PlaneRegularizationParameters& parameters = PlaneRegularizationParameters());

} // namespace pcl_ops
