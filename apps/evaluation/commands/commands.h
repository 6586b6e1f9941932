// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace pcl_ops::evaluation {

/** \brief A command of pcl_ops_evaluate.
 * \param[in] argc, argv the command line from the command on
 * \return the exit code */
using Command = int (int argc, const char* const* argv);

/** \brief Every metric for two labeled clouds. */
Command compareCommand;
/** \brief Which planes of two results are one, and how far apart they are. */
Command planesCommand;
/** \brief How many planes keep their numbers in a sequence of clouds. */
Command trackCommand;
/** \brief Detectors over data sets. */
Command runCommand;
/** \brief How well edges and corners of planes are found. */
Command edgesCommand;
/** \brief The detectors a run can have. */
Command detectorsCommand;

} // namespace pcl_ops::evaluation
