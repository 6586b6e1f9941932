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

PlanFile
planFileOf (const RunFolder& folder);

/** \brief Gives a folder its plan, the one named or a new one, unless it has one. What
 * is in a folder without a plan is removed.
 * \throws UsageError or WorkError if the folder has another one, or unless all of the
 * run's outputs could be written */
void
preparePlan (const TilesOptions& options, const RunFolder& folder);

} // namespace pcl_ops::apps
