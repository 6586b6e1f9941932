// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "report.h"
#include "tasks.h"

namespace pcl_ops::apps {

/** \brief Reads a cloud, finds its planes and writes its outputs.
 * \throws UsageError or WorkError if the cloud cannot be read or an output cannot be
 * written, Interrupted before anything is written */
Report
segmentCloud (const SegmentOptions& options, const Task& task);

} // namespace pcl_ops::apps
