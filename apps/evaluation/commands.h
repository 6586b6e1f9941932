// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace pcl_ops::evaluation {

/** \brief `pcl_ops_evaluate compare`: every metric for two labelled clouds.
 * \param[in] argc, argv the command line from the subcommand on
 * \return the exit code */
int
compareCommand (int argc, const char* const* argv);

/** \brief `pcl_ops_evaluate run`: detectors over data sets, with tables and plots. */
int
runCommand (int argc, const char* const* argv);

/** \brief `pcl_ops_evaluate report`: tables and plots from the results of a run. */
int
reportCommand (int argc, const char* const* argv);

/** \brief `pcl_ops_evaluate detectors`: the configurations by name. */
int
detectorsCommand (int argc, const char* const* argv);

/** \brief `pcl_ops_evaluate pictures`: truth and detectors on chosen clouds. */
int
picturesCommand (int argc, const char* const* argv);

/** \brief `pcl_ops_evaluate truth`: how good a truth region growing makes. */
int
truthCommand (int argc, const char* const* argv);

/** \brief `pcl_ops_evaluate up`: how well the up axis is found from planes. */
int
upCommand (int argc, const char* const* argv);

} // namespace pcl_ops::evaluation
