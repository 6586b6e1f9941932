// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options.h"

#include <string>
#include <vector>

namespace pcl_ops::apps {

inline constexpr const char* program_name = "pcl_ops_segment";

/** \brief What stands for the name of the input in the outputs of a batch. */
inline constexpr const char* name_of_input = "{}";

struct Task {
  /** \brief A file, or "-" for the standard input. */
  std::string input;
  Outputs outputs;
};

struct Batch {
  std::vector<Task> tasks;
  /** \brief What is wrong with inputs that stand for no cloud. */
  std::vector<std::string> problems;
};

/** \brief The one task of a command line without --output-dir, checked down to whether
 * its outputs can be written.
 * \throws UsageError or, for an output, WorkError */
Task
taskOf (const SegmentOptions& options);

/** \brief The tasks of a command line with --output-dir, which is created. Of each
 * input NAME.pcd, the labelled cloud becomes NAME.pcd and the planes NAME.json in there
 * unless --format or --planes say otherwise.
 * \throws UsageError if two inputs would be written to one file or an input would be
 * written over, WorkError if nothing can be written to the folder */
Batch
batchOf (const SegmentOptions& options);

} // namespace pcl_ops::apps
