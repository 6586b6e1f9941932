// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace pcl_ops::evaluation {

/** pcl_ops_evaluate edges; see its --help.
 * \return the exit code */
int
edgesCommand (int argc, const char* const* argv);

} // namespace pcl_ops::evaluation
