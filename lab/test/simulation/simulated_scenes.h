// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <simulation/sensors.h>

#include <algorithm>

namespace pcl_ops::simulation {

/** Rounding error: a few ulp of single precision at room size [m]. */
constexpr double rounding = 2e-6;

/** No draw of Random::gaussian is farther from 0 [sigma]: its 32 bits give at least
 * 2^-32, and the root of -2 ln 2^-32 is 6.66. */
constexpr double largest_gaussian = 6.67;

constexpr double degree = pi / 180.0;

inline const Isometry3d origin = Isometry3d::Identity();

/** Walls of 40 m x 40 m at right angles to the z axis. For a camera at the origin, a
 * wall with its middle at x = 0 fills the view; at x = -20 it fills the left half. */
inline Scene
wallsAt (const std::vector<Vector3d>& middles)
{
  Body wall;
  wall.addSurface (makeRectangle ({0, 0, 0}, {40, 0, 0}, {0, 40, 0}));
  Scene scene;
  for (const Vector3d& middle : middles)
    scene.add (wall, at (middle));
  return scene;
}

} // namespace pcl_ops::simulation
