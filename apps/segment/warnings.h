// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "report.h"

namespace pcl_ops::apps {

/** \brief What is doubtful about all planes that were found, before any is moved or
 * left out. */
std::vector<ResultWarning>
warningsOn (const SegmentOptions& options,
            const Task& task,
            const FileCloud& cloud,
            const ShiftedCloud& shifted,
            const Detected& detected);

/** \brief How many planes are of a kind. */
std::size_t
countOf (PlaneKind kind, const Detected& detected);

} // namespace pcl_ops::apps
