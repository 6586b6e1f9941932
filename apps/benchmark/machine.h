// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

namespace pcl_ops::benchmark {

/** \brief What the times were measured on and with. */
struct Machine {
  std::string cpu;
  /** \brief That may run at a time, by what the system says. */
  unsigned cores = 0;
  /** \brief With its version and flags. */
  std::string compiler;
  std::string pcl_version;
};

Machine
describeMachine ();

/** \brief How many times as fast as one thread two do plain arithmetic, the best of
 * some runs: near 2 where there are two real cores to be had, less where they share one
 * or other programs use them. */
double
arithmeticSpeedup (std::size_t runs);

/** \brief From this speed-up on there are two real cores. */
constexpr double speedup_of_two_cores = 1.8;

} // namespace pcl_ops::benchmark
