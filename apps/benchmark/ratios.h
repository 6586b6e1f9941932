// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud_measures.h"
#include "peak_memory.h"

namespace pcl_ops::benchmark {

/** \brief What was measured on a cloud. */
struct CloudFigures {
  std::string name;
  std::size_t points = 0;
  BestTimes times;
  PeakMemory peak;
};

/** \brief What was measured once. */
struct SharedFigures {
  /** \brief Threads that may run at a time, by what the system says. */
  unsigned cores = 0;
  /** \brief On a large simulated scan. */
  PeakMemory peak;
  /** \brief Time per point at \ref many_points over that at \ref few_points. */
  double growth = std::numeric_limits<double>::quiet_NaN();
};

constexpr std::size_t few_points = 300'000;
constexpr std::size_t many_points = 10'000'000;

/** \brief One measured thing over another. */
struct Ratio {
  /** \brief Its name in JSON. */
  std::string id;
  std::string text;
  /** \brief "" where there is none. */
  std::string unit;
  /** \brief NaN: not measured. */
  double value = std::numeric_limits<double>::quiet_NaN();
};

/** \brief Every ratio on a cloud. Where there is one core, the speed-up by two threads
 * counts as not measured. */
std::vector<Ratio>
ratiosOf (const CloudFigures& figures, const SharedFigures& shared);

/** \brief The ratios' medians over several clouds. */
std::vector<Ratio>
mediansOf (const std::vector<std::vector<Ratio>>& ratios_of_clouds);

} // namespace pcl_ops::benchmark
