// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "report.h"

namespace pcl_ops::apps {

/** \brief What is doubtful about all planes that were found, before any is left out.
 * \param[in] has_camera_poses whether poses look like those of KITTI's camera */
std::vector<ResultWarning>
warningsOn (const SegmentOptions& options,
            const FileCloud& cloud,
            const ShiftedCloud& shifted,
            const Detected& detected,
            bool has_camera_poses);

/** \brief How many of the planes are walls. */
std::size_t
wallsAmong (const Detected& detected);

/** \brief Puts what is doubtful about the plan, if there is one, before all else.
 * \param[in] walls_found planes that were walls before any was left out */
void
addWarningsOnPlan (std::size_t walls_found, Report& report);

} // namespace pcl_ops::apps
