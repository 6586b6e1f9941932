// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "measures.h"
#include "peak_memory.h"

#include <iosfwd>

namespace pcl_ops::benchmark {

/** \brief What was measured on a cloud. */
struct CloudFigures {
  std::string name;
  std::vector<BestTime> times;
  PeakMemory peak;
};

/** \brief Everything that was measured. */
struct Benchmark {
  MeasureParameters parameters;
  std::vector<CloudFigures> clouds;
  /** \brief On a large simulated scan. */
  PeakMemory peak;
};

/** \brief Prints Markdown: the times on a cloud. */
void
printTimes (const CloudFigures& figures, std::ostream& stream);

/** \brief Prints Markdown: how all this was measured, and the peak memory. */
void
printMethod (const Benchmark& benchmark, std::ostream& stream);

/** \brief The JSON of a report, every number; null for what was not measured. */
std::string
jsonOf (const Benchmark& benchmark);

} // namespace pcl_ops::benchmark
