// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud/points.h"
#include <pcl_ops/plane.h>

#include <cstddef>
#include <vector>

namespace pcl_ops::internal {

/** \brief A sample of the finite points of a cloud, with the plane of each point. The
 * same points are sampled in whatever order the cloud has them. */
struct LabeledSample {
  /** \brief The sampled points, relative to \ref origin [m]. */
  Coordinates points;
  /** \brief For each sampled point the position of its plane in the list of planes, or
   * no_plane. */
  Labels labels;
  /** \brief Zero of the frame of \ref points, in the frame of the planes [m]. */
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  /** \brief Number of finite points of the whole cloud. */
  std::size_t finite_points = 0;
  /** \brief Number of points of the whole cloud that are on planes. */
  std::size_t points_on_planes = 0;

  /** \brief Position of a sampled point, by its index, in the frame of the planes. */
  Eigen::Vector3d
  operator[] (std::size_t i) const
  {
    return points[i] + origin;
  }

  /** \brief Share of the finite points of the whole cloud that are on no plane; 0 if
   * there are no finite points. */
  double
  shareOnNoPlane () const
  {
    return finite_points > points_on_planes
               ? static_cast<double> (finite_points - points_on_planes) /
                     static_cast<double> (finite_points)
               : 0.0;
  }
};

/** \brief Samples a cloud, and labels each sampled point with the plane that has it as
 * an inlier.
 * \param[in] shift zero of the cloud's frame, in the frame of the planes [m]
 * \throw std::invalid_argument if an inlier is no point of the cloud */
LabeledSample
sampleWithLabels (const CloudView& cloud,
                  const std::vector<PlaneSegment>& planes,
                  const Eigen::Vector3d& shift);

} // namespace pcl_ops::internal
