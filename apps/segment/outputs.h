// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options.h"
#include "report.h"
#include <io/shifted_cloud.h>

#include <string>

namespace pcl_ops::apps {

/** \brief Whether --planes-dir gives such a name, of a file without its folder. */
bool
isPlaneFile (const std::string& name);

/** \brief Writes what was asked for of a cloud, each file or folder in one step.
 * \throws WorkError if one cannot be written */
void
saveOutputs (const SegmentOptions& options,
             const Outputs& outputs,
             const FileCloud& cloud,
             const ShiftedCloud& shifted,
             const Report& report);

} // namespace pcl_ops::apps
