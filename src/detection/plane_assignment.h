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
  /** \brief Moments of the points of each plane about the origin of their frame. */
  std::vector<Moments> moments;
};

/** \brief Assigns points to planes nearer than \p distance_threshold, theta_h [m].
 * \param[in] planes unbounded planes in the frame of the points
 * \param[in] rule selects the plane if several are near enough
 * \return for each point the index of its plane in \p planes, or no_plane */
Labels
assignPoints (const Coordinates& points,
              const std::vector<Plane>& planes,
              double distance_threshold,
              AssignmentRule rule,
              unsigned threads);

/** \brief Returns the moments of the points of each label from 0 to planes - 1, about
 * the origin of their frame. Points with other labels, as no_plane, are left out. */
std::vector<Moments>
momentsOfLabels (const Coordinates& points,
                 const Labels& labels,
                 std::size_t planes,
                 unsigned threads);

/** \brief Calls \ref assignPoints and adds the moments of the points of each plane. */
AssignedPoints
assignToUnboundedPlanes (const Coordinates& points,
                         const std::vector<Plane>& planes,
                         double distance_threshold,
                         AssignmentRule rule,
                         unsigned threads);

/** \brief Replaces each label by the label of the plane that its plane was merged into.
 * no_plane stays.
 * \param[in] merged_into for each plane its new label, or no_plane if it was dropped */
void
relabel (Labels& labels, const Labels& merged_into, unsigned threads);

} // namespace pcl_ops::internal
