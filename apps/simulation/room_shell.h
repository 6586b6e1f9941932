// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene.h"
#include <base/random.h>

namespace pcl_ops::simulation {

/** \brief Floor, ceiling and four walls of an empty room; some walls have a window
 * niche or a door whose leaf is set back from the wall.
 *
 * \param[in] size length, width and height [m]; the origin is the middle of the floor
 * \param[in,out] generator source of all choices */
Body
makeRoomShell (const Eigen::Vector3d& size, internal::RandomGenerator& generator);

constexpr int corner_walls = 2;

/** \brief The floor and the first \ref corner_walls of such a room, without openings.
 */
Body
makeCornerShell (const Eigen::Vector3d& size);

/** \brief Puts what stands at the origin with its back towards -y against a wall.
 * \param[in] size of the room [m]
 * \param[in] wall 0 to 3
 * \param[in] along shift along the wall from its middle [m]
 * \param[in] gap from the wall's plane [m] */
Eigen::Isometry3d
poseAtWall (const Eigen::Vector3d& size, int wall, double along, double gap);

/** \brief Length of a wall, 0 to 3 [m]. */
double
wallLength (const Eigen::Vector3d& size, int wall);

} // namespace pcl_ops::simulation
