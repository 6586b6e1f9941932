// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "edges/meetings.h"

#include <vector>

namespace pcl_ops::internal {

/** \brief The points that three planes have in common, where an interval of each two of
 * them passes, or ends no farther off than their bridged gap; in ascending order.
 * \param[in] meetings in ascending order
 * \param[in] min_sine of the angle between a plane and the line of two others */
std::vector<PlaneCorner>
cornersOf (const std::vector<Meeting>& meetings,
           const std::vector<PlaneSegment>& planes,
           double min_sine);

/** \brief A meeting's intervals as edges. Each end is drawn to the nearest corner of
 * its planes that is no farther off than the bridged gap, if something of the interval
 * is left then. */
std::vector<PlaneEdge>
edgesOf (const Meeting& meeting, const std::vector<PlaneCorner>& corners);

} // namespace pcl_ops::internal
