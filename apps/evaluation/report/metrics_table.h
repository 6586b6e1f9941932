// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "results_file.h"
#include "text_table.h"

namespace pcl_ops::evaluation {

/** \brief For each data set and kind of truth a table with a row for each
 * configuration: means over the clouds. Configurations come in the order of
 * \ref allConfigurations, others behind; the order of the rows does not matter. */
std::vector<TextTable>
metricsTables (const std::vector<ResultRow>& rows);

/** \brief Writes \ref metricsTables to FOLDER/tables.md and to the standard output.
 * \throw apps::WorkError if the file cannot be written */
void
writeMetricsTables (const std::vector<ResultRow>& rows, const std::string& folder);

} // namespace pcl_ops::evaluation
