// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "results_file.h"

#include <ostream>

namespace pcl_ops::evaluation {

/** \brief Writes tables.md and, in a folder per data set and truth, plots, and prints
 * the tables.
 * \param[in] rows at least one
 * \param[in] folder where to write
 * \param[out]
 * stream gets the tables and a line if gnuplot is missing
 * \throw apps::WorkError if a
 * file cannot be written */
void
writeReport (const std::vector<ResultRow>& rows,
             const std::string& folder,
             std::ostream& stream);

} // namespace pcl_ops::evaluation
