// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "view_state.h"
#include <detection/methods.h>

#include <string>

namespace pcl_ops::apps {

/** \brief What the command line asks for. */
struct ViewOptions {
  std::string input;
  /** \brief The picture to make instead of opening a window; empty for a window. */
  std::string screenshot;
  DetectorOptions detector;
  ViewState state;
  /** \brief Size of the window [pixel]. */
  int width = 1280;
  int height = 960;
};

/** \brief Reads the command line and checks it.
 * \return false if --help or --version was answered and nothing is left to do
 * \throws UsageError or, for the picture, WorkError */
bool
readOptions (int argc, const char* const* argv, ViewOptions& options);

} // namespace pcl_ops::apps
