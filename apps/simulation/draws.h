// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <base/random.h>

#include <cmath>
#include <cstdint>

namespace pcl_ops::simulation {

constexpr double pi = 3.141592653589793;

/** \brief What a stream of random numbers is for. Each purpose has its own stream, so
 * that the same seed gives the same scene whatever the camera and the noise. */
enum class Purpose : std::uint32_t {
  Room = 1,
  CameraPose,
  DepthNoise,
  DenseScan,
  Survey,
  SurveyScan,
  Shapes,
  ShapesScan,
  Corner,
  Town,
  Walk,
  PoseError,
  Street,
  SensorPose,
  LidarNoise,
  Drive
};

inline internal::RandomGenerator
makeGenerator (std::uint32_t seed, Purpose purpose)
{
  std::seed_seq sequence{seed, std::uint32_t (purpose)};
  return internal::RandomGenerator (sequence);
}

/** \brief Uniform draw from [lower, upper). */
inline double
drawBetween (internal::RandomGenerator& generator, double lower, double upper)
{
  return lower + (upper - lower) * internal::drawUnit (generator);
}

/** \brief Uniform draw from a box, z first: arguments of one call would be drawn in
 * whatever order the compiler likes. Takes no random number for an edge of length 0. */
inline Eigen::Vector3d
drawInBox (internal::RandomGenerator& generator,
           const Eigen::Vector3d& lower,
           const Eigen::Vector3d& upper)
{
  Eigen::Vector3d drawn = lower;
  for (const int axis : {2, 1, 0})
    if (lower[axis] < upper[axis])
      drawn[axis] = drawBetween (generator, lower[axis], upper[axis]);
  return drawn;
}

/** \brief True with the given probability. */
inline bool
drawChance (internal::RandomGenerator& generator, double probability)
{
  return internal::drawUnit (generator) < probability;
}

/** \brief Draw from the standard normal distribution (Box & Muller 1958). */
inline double
drawGaussian (internal::RandomGenerator& generator)
{
  const double radius =
      std::sqrt (-2.0 * std::log (1.0 - internal::drawUnit (generator)));
  return radius * std::cos (2.0 * pi * internal::drawUnit (generator));
}

} // namespace pcl_ops::simulation
