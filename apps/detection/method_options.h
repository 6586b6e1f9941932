// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "methods.h"

#include <string>

namespace pcl_ops::apps {

/** \brief Declares --method, the options all methods share, and under a title for each
 * method its own. */
void
declareMethodOptions (CommandLine& line, std::string& method, DetectorOptions& options);

/** \brief Refuses options on the parsed line that only other methods understand.
 * \throws UsageError */
void
checkMethodOptions (const CommandLine& line, const Method& chosen);

/** \brief Of what voxels of a given size begin at whole multiples; 0 where their size
 * is not given. */
double
voxelStepOf (const DetectorOptions& options);

} // namespace pcl_ops::apps
