// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "depth_noise.h"
#include "walk.h"
#include <cli/progress.h>

#include <cstdint>
#include <string>

namespace pcl_ops::simulation {

/** \brief What is seen on a walk, and how. */
struct WalkRecording {
  Room room;
  DepthCamera camera;
  Poses poses;
  NoiseParameters noise;
  bool organized = false;
};

/** \brief Writes what the camera sees as FOLDER/frame_000.pcd and so on, in its own
 * frame: x right, y down, z forward. The label of a surface is the same in all frames.
 * \param[in,out] progress of all frames
 * \return points in all of them
 * \throw WorkError if one cannot be written */
std::uint64_t
saveWalk (const std::string& folder,
          const WalkRecording& walk,
          std::uint32_t seed,
          apps::Progress& progress);

} // namespace pcl_ops::simulation
