// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud/points.h"
#include <pcl_ops/plane.h>

#include <vector>

namespace pcl_ops::internal {

/** \brief The plane of each point, and the moments of each plane. */
struct AssignedPoints {
  Labels labels;
  /** \brief Moments of the points of each plane about the zero of their frame. */
  std::vector<Moments> moments;
};

/** \brief Gives every point the number of a plane that is nearer than \p
 * distance_threshold, theta_h [m], or no_plane.
 * \param[in] planes in the frame of the points, without borders
 * \param[in] rule which one, if several are near enough */
Labels
assignPoints (const Coordinates& points,
              const std::vector<Plane>& planes,
              double distance_threshold,
              AssignmentRule rule,
              unsigned threads);

/** \brief Moments of the points of each label from 0 to number - 1, about the zero of
 * their frame. */
std::vector<Moments>
momentsOfLabels (const Coordinates& points,
                 const Labels& labels,
                 std::size_t number,
                 unsigned threads);

/** \brief \ref assignPoints, with the moments of the points of each plane. */
AssignedPoints
assignToUnboundedPlanes (const Coordinates& points,
                         const std::vector<Plane>& planes,
                         double distance_threshold,
                         AssignmentRule rule,
                         unsigned threads);

/** \brief Replaces every label by the plane it was merged into. */
void
relabel (Labels& labels, const Labels& merged_into, unsigned threads);

} // namespace pcl_ops::internal
