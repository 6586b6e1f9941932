// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "room_shell.h"

#include "openings.h"
#include "poses.h"

namespace pcl_ops::simulation {

namespace {

using Eigen::Vector3d;

/** \brief Of a door [m]. */
constexpr double threshold_height = 0.02;

/** \brief Floor or ceiling. */
Rectangle
level (const Vector3d& size, double z)
{
  return {z * Vector3d::UnitZ(),
          Vector3d::UnitX(),
          Vector3d::UnitY(),
          0.5 * size.x(),
          0.5 * size.y()};
}

Opening
drawOpening (double length, internal::RandomGenerator& generator)
{
  const bool door = drawChance (generator, 0.4);
  const double width = door ? 0.9 : drawBetween (generator, 0.9, 1.7);
  const double reach = 0.5 * (length - width) - 0.2;
  const double middle = drawBetween (generator, -reach, reach);
  const double bottom = door ? threshold_height : drawBetween (generator, 0.8, 1.0);
  const double top = door ? 2.05 : drawBetween (generator, 1.9, 2.2);
  const double depth =
      door ? drawBetween (generator, 0.07, 0.15) : drawBetween (generator, 0.12, 0.3);
  return {middle - 0.5 * width, middle + 0.5 * width, bottom, top, depth};
}

Body
makeWall (double length, double height, internal::RandomGenerator& generator)
{
  Body wall;
  if (drawChance (generator, 0.6)) {
    const Opening opening = drawOpening (length, generator);
    addWallAround (
        wall, opening, upright (-0.5 * length, 0.5 * length, 0.0, height, 0.0));
    addRecess (wall, opening);
  }
  else
    addSurface (wall, upright (-0.5 * length, 0.5 * length, 0.0, height, 0.0));
  return wall;
}

} // namespace

double
wallLength (const Vector3d& size, int wall)
{
  return wall % 2 == 0 ? size.x() : size.y();
}

Eigen::Isometry3d
poseAtWall (const Vector3d& size, int wall, double along, double gap)
{
  const double to_wall = 0.5 * wallLength (size, wall + 1);
  return turned (0.5 * pi * wall, Vector3d::UnitZ()) * at (along, gap - to_wall, 0.0);
}

Body
makeRoomShell (const Vector3d& size, internal::RandomGenerator& generator)
{
  Body shell;
  for (const double z : {0.0, size.z()})
    addSurface (shell, level (size, z));
  for (int wall = 0; wall < 4; ++wall)
    addPart (shell,
             makeWall (wallLength (size, wall), size.z(), generator),
             poseAtWall (size, wall, 0.0, 0.0));
  return shell;
}

Body
makeCornerShell (const Vector3d& size)
{
  Body shell;
  addSurface (shell, level (size, 0.0));
  for (int wall = 0; wall < corner_walls; ++wall) {
    const double half_length = 0.5 * wallLength (size, wall);
    Body plain;
    addSurface (plain, upright (-half_length, half_length, 0.0, size.z(), 0.0));
    addPart (shell, plain, poseAtWall (size, wall, 0.0, 0.0));
  }
  return shell;
}

} // namespace pcl_ops::simulation
