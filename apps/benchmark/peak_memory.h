// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <evaluation/detectors/detectors.h>

#include <limits>

namespace pcl_ops::benchmark {

/** \brief Memory at the peak of a detection. */
struct PeakMemory {
  std::size_t points = 0;
  double cloud_bytes = std::numeric_limits<double>::quiet_NaN();
  /** \brief What the detection needs on top of the cloud; NaN where the system does not
   * tell. */
  double extra_bytes = std::numeric_limits<double>::quiet_NaN();
};

/** \brief Runs a detector on one thread in a child process and takes by how much its
 * resident memory grows at the peak, labels of all points included.
 * \param[in] cloud finite points */
PeakMemory
peakMemoryOn (const evaluation::XyzCloud::ConstPtr& cloud,
              const evaluation::Configuration& detector);

/** \brief The same of the default preset. */
PeakMemory
peakMemoryOn (const evaluation::XyzCloud::ConstPtr& cloud);

} // namespace pcl_ops::benchmark
