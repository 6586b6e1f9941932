// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace pcl_ops::evaluation {

/** Of pcl_ops_evaluate, explained by --help; returns the exit code. */
using Command = int (int argc, const char* const* argv);

Command compareCommand, planesCommand, trackCommand, edgesCommand;

} // namespace pcl_ops::evaluation
