// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <detection/methods.h>

#include <string>

namespace pcl_ops::apps {

/** \brief What the command line asks for. */
struct SegmentOptions {
  std::string input;
  /** \brief Outputs; empty where not asked for. */
  std::string output, planes, image;
  std::string method = "ops";
  DetectorOptions detector;
  bool keep_color = false;
  bool quiet = false;
};

/** \brief Reads the command line and checks it, down to whether the outputs can be
 * written, before any work is done.
 * \return false if --help or --version was answered and nothing is left to do
 * \throws UsageError or, for an output, WorkError */
bool
readOptions (int argc, const char* const* argv, SegmentOptions& options);

} // namespace pcl_ops::apps
