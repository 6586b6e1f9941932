// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "summary.h"

namespace pcl_ops::evaluation {

/** \brief Writes plots of a data set's results into a folder: accuracies over time, a
 * point per configuration, and accuracy over sampling rate, a line per number of
 * neighbours. Each is a .dat file with the numbers, a .gp file for gnuplot and, where
 * gnuplot is installed, a .png file.
 * \return whether the .png files were made
 * \throw apps::WorkError if a file cannot be written */
bool
writePlots (const DataSetSummary& summary, const std::string& folder);

} // namespace pcl_ops::evaluation
