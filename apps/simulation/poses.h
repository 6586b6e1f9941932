// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "room.h"

namespace pcl_ops::simulation {

/** \brief Where the sensor is in each frame: from its own frame to that of the scene.
 */
using Poses = std::vector<Isometry3d>;

/** \brief Number of surfaces well in view of a depth camera, none if something stands
 * just before it. */
int
countVisibleSurfaces (const Scene& scene, const Isometry3d& pose);

/** \brief Draws a pose at a person's height in the room, upright to a few degrees, that
 * sees many surfaces and has nothing just in front of it. */
Isometry3d
drawCameraPose (const Room& room, std::uint32_t seed);

/** \brief Draws a walk through a room: three quarters of the way around its middle,
 * looking across it, so that walls come and go and the first comes again; at a person's
 * height, which rises and falls with the steps. */
Poses
drawWalk (const Room& room, std::size_t frames, std::uint32_t seed);

/** \brief How far poses are off, as root mean square: a turn of so many degrees about
 * the sensor, and a shift of so many centimeters. */
struct PoseErrors {
  /** \brief Of each pose by itself, and of each step between two: these add up. */
  double each = 0.0, drift = 0.0;
};

/** \brief Poses as a measurement would have them. */
Poses
measured (const Poses& poses, const PoseErrors& errors, std::uint32_t seed);

} // namespace pcl_ops::simulation
