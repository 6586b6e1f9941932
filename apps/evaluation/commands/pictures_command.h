// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace pcl_ops::evaluation {

/** \brief `pcl_ops_evaluate pictures`: truth and detectors on chosen clouds.
 * \param[in] argc, argv the command line from the subcommand on
 * \return the exit code */
int
picturesCommand (int argc, const char* const* argv);

} // namespace pcl_ops::evaluation
