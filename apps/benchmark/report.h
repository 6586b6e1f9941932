// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ratios.h"

#include <iosfwd>

namespace pcl_ops::benchmark {

/** \brief Everything that was measured. */
struct Benchmark {
  MeasureParameters parameters;
  std::vector<CloudFigures> clouds;
  SharedFigures shared;
};

/** \brief Prints Markdown: the times on a cloud. */
void
printTimes (const CloudFigures& figures, std::ostream& stream);

/** \brief Prints Markdown: for each cloud a table of ratios, their medians
 * where there are several clouds, and how all this was measured. */
void
printReport (const Benchmark& benchmark, std::ostream& stream);

/** \brief The JSON of a report, every number; null for what was not measured. */
std::string
jsonOf (const Benchmark& benchmark);

} // namespace pcl_ops::benchmark
