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

struct PlaneRegularizationParameters {
  /** \brief Planes this near to parallel or to orthogonal are meant to be so [rad];
   * default 3 degrees. */
  double max_angle = 3.0 * (M_PI / 180.0);
  /** \brief Parallel planes this near are meant to be one [m]; automatic: three times
   * their rms. */
  std::optional<double> max_offset;
  /** \brief How far the points of a plane may be from where they were beside it, as a
   * root mean square in multiples of their rms distance to it: a plane that would be
   * moved farther stays, as one of rms 0 does. As the covariance of a plane is rms^2
   * (A^T A)^-1 (\ref independentPlaneCovariance), a move of 1 is sqrt (n) of its
   * standard deviations, n points. */
  double max_displacement = 1.0;
};

/** \brief What is wrong with parameters, as a sentence; empty if nothing is. */
PCL_OPS_EXPORT std::string
validate (const PlaneRegularizationParameters& parameters);

/** \brief How a plane was moved. */
struct PlaneMove {
  /** \brief Turned about its centroid by this [rad], then moved along its normal by
   * this [m]. */
  double angle = 0.0;
  double offset = 0.0;
  /** \brief As \ref PlaneRegularizationParameters::max_displacement has it; of a plane
   * that stays the one it would have had. */
  double displacement = 0.0;
  bool is_moved = false;
  /** \brief Planes with the same numbers are parallel, coplanar; a plane that stays has
   * numbers of its own. */
  std::size_t direction = 0;
  std::size_t level = 0;
};

struct RegularizedPlanes {
  /** \brief In the order of the input, with moved centroids and normals; their moments,
   * and so their rms about the new plane, are those of the same inliers. */
  std::vector<PlaneSegment> planes;
  std::vector<PlaneMove> moves;
};

/** \brief Makes nearly parallel, orthogonal and coplanar planes exactly so, as the
 * walls of a building are meant to be.
 *
 * Directions within max_angle of one another become their mean, weighted by points,
 * from the largest plane on. Then those that are within max_angle of a right angle to
 * larger ones become orthogonal to these. Each plane turns about its centroid; of
 * parallel ones, those nearer than max_offset get one offset (after Verdie, Lafarge &
 * Alliez, *LOD generation for urban scenes*, ACM Transactions on Graphics 34, 2015, as
 * CGAL's regularize_planes, without its symmetry about an axis). A plane that would be
 * moved by more than max_displacement stays as it was, and the others do not follow it.
 * \throw std::invalid_argument if there is a problem with the parameters, or a
 * centroid or normal is not finite */
PCL_OPS_EXPORT RegularizedPlanes
regularizePlanes (
    const std::vector<PlaneSegment>& planes,
    const PlaneRegularizationParameters& parameters = PlaneRegularizationParameters());

} // namespace pcl_ops
