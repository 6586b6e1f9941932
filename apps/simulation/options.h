// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "simulate.h"

namespace pcl_ops::simulation {

inline constexpr const char* program_name = "pcl_ops_simulate";

/** \brief What the command line asks for. */
struct SimulationOptions {
  std::string output;
  Simulation simulation;
  double tiles = 4;
  std::uint32_t frames = 50;
  /** \brief See \ref measured. */
  double pose_error = 0.0;
  bool quiet = false;
};

/** \return false if the answer was --help or --version
 * \throws UsageError */
bool
readOptions (int argc, const char* const* argv, SimulationOptions& options);

} // namespace pcl_ops::simulation
