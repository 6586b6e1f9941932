// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options.h"

namespace pcl_ops::apps {

/** \brief Segments clouds, options.jobs at a time. Goes on after one that fails; ends
 * early when the user interrupts it, with each cloud's outputs either complete or
 * untouched. Prints lines and numbers planes in the order of the tasks: both are the
 * same for any number of jobs.
 * \return the exit code, ExitCode::work_failed if any failed or was left */
int
runBatch (const SegmentOptions& options, const Batch& batch);

} // namespace pcl_ops::apps
