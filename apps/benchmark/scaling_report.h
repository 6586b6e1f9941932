// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scaling.h"

namespace pcl_ops::benchmark {

/** \brief Writes scaling.csv and a plot of each series into a folder.
 * \return whether the plots were drawn
 * \throw apps::WorkError if a file cannot be written */
bool
writeScaling (const std::vector<ScalingRow>& rows, const std::string& folder);

} // namespace pcl_ops::benchmark
