// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "poses.h"

#include <cstdint>
#include <optional>
#include <string>

namespace pcl_ops::simulation {

inline constexpr const char* program_name = "pcl_ops_simulate";

/** \brief What the command line asks for. */
struct SimulationOptions {
  std::string output;
  std::string scene = "room";
  std::uint32_t seed = 1;
  DepthCamera camera;
  std::string sensor = "lidar-64";
  std::string profile = "correlated";
  double noise = 1.0;
  std::optional<double> points;
  std::optional<double> tiles;
  std::uint32_t frames = 50;
  PoseErrors pose_errors;
  bool organized = false;
  bool quiet = false;

  CloudLayout
  layout () const
  {
    return organized ? CloudLayout::Organized : CloudLayout::Readings;
  }
};

inline bool
isSeenByLidar (const std::string& scene)
{
  return scene == "street" || scene == "drive";
}

/** \brief Whether the scene is seen in many frames. */
inline bool
isOnTheWay (const std::string& scene)
{
  return scene == "walk" || scene == "drive";
}

/** \brief Whether the output is a folder. */
inline bool
isOfManyFiles (const std::string& scene)
{
  return scene == "town" || isOnTheWay (scene);
}

/** \return false if the answer was --help or --version
 * \throws UsageError */
bool
readOptions (int argc, const char* const* argv, SimulationOptions& options);

} // namespace pcl_ops::simulation
