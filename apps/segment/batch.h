// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options.h"
#include <cli/program.h>

#include <ostream>

namespace pcl_ops::apps {

/** \brief Segments one cloud after the other, options.jobs at a time. Goes on after one
 * that fails; ends early when the user interrupts it, with each cloud's outputs either
 * complete or untouched.
 * \param[out] out one line for each cloud done, in the order of the tasks, unless quiet
 * \param[out] messages one line for each problem, in the same order, and the progress
 * \param[in] is_terminal whether \p messages is one: then with a bar
 * \return the exit code, ExitCode::work_failed if any failed or was left */
int
runBatch (const SegmentOptions& options,
          const Batch& batch,
          std::ostream& out,
          std::ostream& messages,
          bool is_terminal);

} // namespace pcl_ops::apps
