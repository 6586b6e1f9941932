// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "machine.h"
#include "ratios.h"

#include <iosfwd>

namespace pcl_ops::benchmark {

/** \brief Everything that was measured. */
struct Benchmark {
  Machine machine;
  MeasureParameters parameters;
  std::vector<CloudFigures> clouds;
  SharedFigures shared;
};

/** \brief Prints Markdown: for each cloud a table of ratios, their medians
 * where there are several clouds, and how all this was measured. */
void
printReport (const Benchmark& benchmark, std::ostream& stream);

} // namespace pcl_ops::benchmark
