// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options.h"
#include "run_folder.h"

#include <string>

namespace pcl_ops::apps {

/** \brief The plan of a run that has none yet. \throws WorkError as \ref makePlan */
Plan
newPlan (const TilesOptions& options);

/** \brief Writes a plan unless there is one that fits.
 * \throws UsageError or WorkError unless all of the run's outputs could be written */
void
preparePlan (const TilesOptions& options,
             const std::string& file,
             const RunFolder& folder);

} // namespace pcl_ops::apps
