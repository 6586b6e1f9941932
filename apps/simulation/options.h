// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "poses.h"
#include "simulate.h"

namespace pcl_ops::simulation {

inline constexpr const char* program_name = "pcl_ops_simulate";

/** \brief What the command line asks for. */
struct SimulationOptions {
  std::string output;
  Simulation simulation;
  double tiles = 4;
  std::uint32_t frames = 50;
  PoseErrors pose_errors;
  bool quiet = false;

  bool
  isOnTheWay () const
  {
    return simulation.scene == "walk" || simulation.scene == "drive";
  }

  /** \brief Whether the output is a folder. */
  bool
  isOfManyFiles () const
  {
    return simulation.scene == "town" || isOnTheWay();
  }
};

/** \return false if the answer was --help or --version
 * \throws UsageError */
bool
readOptions (int argc, const char* const* argv, SimulationOptions& options);

} // namespace pcl_ops::simulation
