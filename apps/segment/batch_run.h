// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options.h"

namespace pcl_ops::apps {

/** \brief Segments the clouds of a batch, SegmentOptions::jobs at a time. If one fails,
 * the others are segmented all the same. An interruption by the user ends the batch
 * early, without a half-written file. Lines are printed and ids are given in the order
 * of the tasks, so that both are the same for any number of jobs.
 * \return the exit code: ExitCode::work_failed if the only input failed
 * \throws WorkError if one of several inputs failed, after an interruption, or if
 * --poses does not fit the clouds; UsageError if --up camera does not fit --poses */
int
runBatch (const SegmentOptions& options, const Batch& batch);

} // namespace pcl_ops::apps
