// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "depth_camera.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl_ops::simulation {

/** \brief Where the camera is in each frame: from its own frame to the room's. */
using Poses = std::vector<Eigen::Isometry3d>;

/** \brief Draws a walk through a room: three quarters of the way around its middle,
 * looking across it, so that walls come and go and the first comes again; at a person's
 * height, which rises and falls with the steps.
 * \param[in] camera its range and field of view count
 * \param[in] seed the same seed and room give the same walk */
Poses
drawWalk (const Room& room,
          const DepthCamera& camera,
          std::size_t frames,
          std::uint32_t seed);

/** \brief How far poses are off, as root mean square: a turn of so many degrees about
 * the camera, and a shift of so many centimetres. */
struct PoseErrors {
  /** \brief Of each pose by itself. */
  double each = 0.0;
  /** \brief Of each step between two, so that they add up. */
  double drift = 0.0;
};

/** \brief Poses as a measurement would have them. */
Poses
measured (const Poses& poses, const PoseErrors& errors, std::uint32_t seed);

} // namespace pcl_ops::simulation
