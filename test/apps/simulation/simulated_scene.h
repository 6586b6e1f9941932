// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <simulation/depth_noise.h>

#include <cstdint>
#include <string>

namespace pcl_ops::simulation {

/** \brief FNV-1a of the test's name: adding a test never changes another one's room. */
inline std::uint32_t
seedOfTest ()
{
  std::uint32_t hash = 2166136261u;
  for (const char c :
       std::string (testing::UnitTest::GetInstance()->current_test_info()->name()))
    hash = (hash ^ std::uint8_t (c)) * 16777619u;
  return hash;
}

inline NoiseParameters
noiseOf (NoiseProfile profile)
{
  NoiseParameters noise;
  noise.profile = profile;
  return noise;
}

/** \brief A small camera at the origin that looks along z. */
inline DepthCamera
smallCamera ()
{
  DepthCamera camera;
  camera.width = 160;
  camera.height = 120;
  return camera;
}

/** \brief A wall across the view of a camera at the origin, larger than the view. */
inline Scene
wallAt (double depth)
{
  Body wall;
  Rectangle rectangle;
  rectangle.half_u = rectangle.half_v = 20.0;
  addSurface (wall, rectangle);
  Scene scene;
  addBody (scene, wall, Eigen::Isometry3d (Eigen::Translation3d (0.0, 0.0, depth)));
  return scene;
}

/** \brief A near wall that covers the left half of the view before a far one. */
inline Scene
stepScene (double near, double far)
{
  Body wall;
  Rectangle rectangle;
  rectangle.half_u = rectangle.half_v = 20.0;
  addSurface (wall, rectangle);
  Scene scene = wallAt (far);
  addBody (scene, wall, Eigen::Isometry3d (Eigen::Translation3d (-20.0, 0.0, near)));
  return scene;
}

} // namespace pcl_ops::simulation
