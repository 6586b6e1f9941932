// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "summary.h"
#include "text_table.h"

namespace pcl_ops::evaluation {

/** \brief The tables of a data set: Tables I to IV of the paper, numbers of planes, all
 * metrics, true planes found by size and by width, and all stages' times, each with the
 * paper's figures where it has them. Tables without a row are left out. */
std::vector<TextTable>
tablesOf (const DataSetSummary& summary);

} // namespace pcl_ops::evaluation
