// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene.h"

namespace pcl_ops::simulation {

/** \brief A furnished rectangular room; z is up, z = 0 the floor, the origin the middle
 * of the floor. The walls are turned by \ref yaw against the x and y axes. */
struct Room {
  Scene scene;
  Vector3d size = Vector3d::Zero(); // length, width and height [m]
  double yaw = 0.0;                 // [rad]
};

/** \brief Draws a room with doors, niches, furniture, tilted boards and round clutter.
 */
Room
makeRoom (Seed seed);

/** \brief Draws the corner of a room, a floor and two walls, with tables, benches and
 * racks of boards on posts: narrow planes beside wide ones. */
Room
makeFurnishedCorner (Seed seed);

/** \brief Number of surfaces well in view of a depth camera, none if something stands
 * just before it. */
int
countVisibleSurfaces (const Scene& scene, const Isometry3d& pose);

/** \brief Draws a pose at a person's height in the room, upright to a few degrees, that
 * sees many surfaces and has nothing just in front of it. */
Isometry3d
drawCameraPose (const Room& room, Seed seed);

/** \brief Draws a walk through a room: three quarters of the way around its middle,
 * looking across it, so that walls come and go and the first comes again; at a person's
 * height, which rises and falls with the steps. */
Poses
drawWalk (const Room& room, std::size_t frames, Seed seed);

} // namespace pcl_ops::simulation
