// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace pcl_ops::evaluation {

/** \brief `pcl_ops_evaluate track`: how well planes keep their numbers.
 * \param[in] argc, argv the command line from the subcommand on
 * \return the exit code */
int
trackCommand (int argc, const char* const* argv);

} // namespace pcl_ops::evaluation
