// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "report.h"

namespace pcl_ops::apps {

/** \brief Returns warnings on the planes of a cloud (resultWarnings).
 * \param[in] shifted the points of \p cloud in which the planes were found
 * \param[in] detected planes before planes are regularized or dropped */
std::vector<ResultWarning>
warningsOn (const SegmentOptions& options,
            const Task& task,
            const FileCloud& cloud,
            const ShiftedCloud& shifted,
            const Detected& detected);

} // namespace pcl_ops::apps
