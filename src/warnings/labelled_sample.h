// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud/points.h"
#include <pcl_ops/plane.h>

#include <cstddef>
#include <vector>

namespace pcl_ops::internal {

/** \brief A sample of the finite points of a cloud, with the plane of each point. The
 * order of the cloud's points does not change which are sampled. */
struct LabelledSample {
  /** \brief Relative to \ref origin. */
  Coordinates points;
  /** \brief For each point the position of its plane, or no_plane. */
  Labels labels;
  /** \brief Zero of the frame of \ref points, in the frame of the planes. */
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  /** \brief How many points of the cloud are finite, and how many are on planes. */
  std::size_t finite = 0;
  std::size_t on_planes = 0;

  /** \brief A point in the frame of the planes. */
  Eigen::Vector3d
  operator[] (std::size_t i) const
  {
    return points[i] + origin;
  }

  /** \brief Share of the finite points of the cloud that are on no plane. */
  double
  shareOnNoPlane () const
  {
    return finite > on_planes
               ? static_cast<double> (finite - on_planes) / static_cast<double> (finite)
               : 0.0;
  }
};

/** \brief Samples a cloud, and labels each sampled point with the plane that has it as
 * an inlier.
 * \param[in] shift zero of the cloud's frame, in the frame of the planes
 * \throw std::invalid_argument if an inlier is no point of the cloud */
LabelledSample
sampleWithLabels (const CloudView& cloud,
                  const std::vector<PlaneSegment>& planes,
                  const Eigen::Vector3d& shift);

} // namespace pcl_ops::internal
