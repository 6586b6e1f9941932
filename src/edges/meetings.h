// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "edges/intervals.h"
#include <pcl_ops/plane_edges.h>

#include <cstddef>
#include <vector>

namespace pcl_ops::internal {

/** \brief The points origin + t direction. */
struct Line {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  /** \brief Of length 1. */
  Eigen::Vector3d direction = Eigen::Vector3d::UnitX();

  Eigen::Vector3d
  at (double t) const
  {
    return origin + t * direction;
  }
};

/** \brief Two planes with points of both along their line. */
struct Meeting {
  std::size_t first, second;
  Line line;
  /** \brief Between the planes, 0 to pi/2 [rad]. */
  double angle;
  /** \brief How far two ends may be apart that are one. */
  double max_gap;
  Intervals intervals;
};

/** \brief Signed distance of a point, exact far from zero where offsets are not. */
inline double
signedDistance (const Eigen::Vector3d& point, const PlaneSegment& plane)
{
  return plane.normal.dot (point - plane.centroid);
}

/** \brief All that meet, by their first plane, then by their second. Parameters are
 * those of findPlaneEdges. */
std::vector<Meeting>
meetingsOf (const CloudView& cloud,
            const std::vector<PlaneSegment>& planes,
            const PlaneEdgeParameters& parameters,
            const Eigen::Vector3d& shift);

} // namespace pcl_ops::internal
