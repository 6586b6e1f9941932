// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "report.h"

#include <string>

namespace pcl_ops::benchmark {

/** \brief The JSON of a report, every number; null for what was not measured. */
std::string
jsonOf (const Benchmark& benchmark);

} // namespace pcl_ops::benchmark
