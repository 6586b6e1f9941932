// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud/points.h"
#include <pcl_ops/plane.h>

#include <vector>

namespace pcl_ops::internal {

/** \brief The plane of each point and the moments of each plane. */
struct AssignedPoints {
  Labels labels;
  /** \brief Moments of the points of each plane, about the zero of their frame. */
  std::vector<Moments> moments;
};

/** \brief Assigns points to planes nearer than a threshold.
 * \param[in] planes unbounded planes in the frame of the points
 * \param[in] distance_threshold theta_h [m]
 * \param[in] rule selects the plane if several are near enough
 * \return for each point the index of its plane in \p planes, or no_plane */
Labels
assignPoints (const Coordinates& points,
              const std::vector<Plane>& planes,
              double distance_threshold,
              AssignmentRule rule,
              unsigned threads);

/** \brief Returns the moments of the points of each label from 0 to planes - 1, about
 * the zero of their frame. Points with other labels, as no_plane, are left out. */
std::vector<Moments>
momentsOfLabels (const Coordinates& points,
                 const Labels& labels,
                 std::size_t planes,
                 unsigned threads);

/** \brief Calls \ref assignPoints, and returns its labels with the moments of the
 * points of each plane. */
AssignedPoints
assignToUnboundedPlanes (const Coordinates& points,
                         const std::vector<Plane>& planes,
                         double distance_threshold,
                         AssignmentRule rule,
                         unsigned threads);

/** \brief Replaces each label by the new label of its plane; no_plane stays.
 * \param[in] merged_into for each plane the label of the plane that it was merged into,
 * or no_plane if it was dropped */
void
relabel (Labels& labels, const Labels& merged_into, unsigned threads);

} // namespace pcl_ops::internal
