// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace pcl_ops::evaluation {

/** \brief `pcl_ops_evaluate up`: how well the up axis is found from planes.
 * \param[in] argc, argv the command line from the subcommand on
 * \return the exit code */
int
upCommand (int argc, const char* const* argv);

} // namespace pcl_ops::evaluation
