// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <simulation/sensors.h>

#include <algorithm>

namespace pcl_ops::simulation {

/** A few ulp of single precision at room size [m]. */
constexpr double rounding = 2e-6;

constexpr double degree = pi / 180.0;

inline const Isometry3d origin = Isometry3d::Identity();

/** Adds a wall of 40 m x 40 m across the z axis. */
inline void
addWall (Scene& scene, double x, double depth)
{
  Body wall;
  wall.addSurface (makeRectangle ({0, 0, 0}, {40, 0, 0}, {0, 40, 0}));
  scene.add (wall, at ({x, 0, depth}));
}

/** A wall across the view of a camera at the origin, larger than the view. */
inline Scene
wallAt (double depth)
{
  Scene scene;
  addWall (scene, 0.0, depth);
  return scene;
}

/** A near wall that covers the left half of the view before a far one. */
inline Scene
stepScene (double near, double far)
{
  Scene scene = wallAt (far);
  addWall (scene, -20.0, near);
  return scene;
}

} // namespace pcl_ops::simulation
