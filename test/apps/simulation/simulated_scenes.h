// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <simulation/sensors.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace pcl_ops::simulation {

/** \brief A few ulp of single precision at room size [m]. */
constexpr double rounding = 2e-6;

/** \brief No draw of a Gaussian with 32 random bits is farther from 0 [sigma]. */
constexpr double largest_gaussian = 6.67;

constexpr double degree = pi / 180.0;

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

/** \brief The seed of the test and those that follow it. */
inline std::vector<std::uint32_t>
seedsOfTest (std::uint32_t count)
{
  std::vector<std::uint32_t> seeds;
  for (std::uint32_t i = 0; i < count; ++i)
    seeds.push_back (seedOfTest() + i);
  return seeds;
}

/** \brief Adds a wall of 40 m x 40 m across the z axis. */
inline void
addWall (Scene& scene, double x, double depth)
{
  Body wall;
  wall.addSurface (makeRectangle ({0, 0, 0}, {40, 0, 0}, {0, 40, 0}));
  scene.add (wall, at ({x, 0, depth}));
}

/** \brief A wall across the view of a camera at the origin, larger than the view. */
inline Scene
wallAt (double depth)
{
  Scene scene;
  addWall (scene, 0.0, depth);
  return scene;
}

/** \brief A near wall that covers the left half of the view before a far one. */
inline Scene
stepScene (double near, double far)
{
  Scene scene = wallAt (far);
  addWall (scene, -20.0, near);
  return scene;
}

inline bool
haveSamePoints (const SimulatedCloud& a, const SimulatedCloud& b)
{
  return std::equal (a.cloud.begin(),
                     a.cloud.end(),
                     b.cloud.begin(),
                     b.cloud.end(),
                     [] (const auto& p, const auto& q) {
                       return p.getVector3fMap() == q.getVector3fMap() &&
                              p.label == q.label;
                     });
}

inline double
largestDistanceToTruth (const SimulatedCloud& simulated)
{
  double largest = 0.0;
  for (const auto& point : simulated.cloud)
    if (point.label > 0) {
      const Plane& plane = simulated.planes.at (point.label - 1);
      const Eigen::Vector3d position = point.getVector3fMap().cast<double>();
      largest = std::max (largest, std::abs (plane.distance (position)));
    }
  return largest;
}

} // namespace pcl_ops::simulation
