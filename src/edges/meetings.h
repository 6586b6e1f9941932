// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "edges/intervals.h"
#include "edges/plane_meeting.h"
#include <pcl_ops/plane_edges.h>

#include <cstddef>
#include <vector>

namespace pcl_ops::internal {

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

/** \brief All that meet, by their first plane, then by their second. Parameters are
 * those of findPlaneEdges. */
std::vector<Meeting>
meetingsOf (const CloudView& cloud,
            const std::vector<PlaneSegment>& planes,
            const PlaneEdgeParameters& parameters,
            const Eigen::Vector3d& shift);

} // namespace pcl_ops::internal
