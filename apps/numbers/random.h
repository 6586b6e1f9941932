// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <numbers/angles.h>

#include <cmath>
#include <cstdint>
#include <random>

namespace pcl_ops::apps {

/** \brief A generator of random numbers, the same with every compiler: the standard
 * fixes the output of std::mt19937, but not that of the std:: distributions. Only the
 * last bit may differ where logarithms and cosines are used. */
class Random {
public:
  explicit Random (std::uint32_t seed) : generator_ (seed) {}
  /** \brief For a seed of several numbers. */
  explicit Random (std::seed_seq&& seeds) : generator_ (seeds) {}

  /** \brief 32 random bits. */
  std::uint32_t
  bits ()
  {
    return generator_();
  }

  /** \brief Uniform integer from 0 to bound - 1, both included, without bias (Lemire
   * 2019); bound 0 counts as 1. */
  std::uint32_t
  below (std::uint32_t bound)
  {
    if (bound < 2)
      return 0;
    // 2^32 mod bound: so many of the 2^32 values of the bits are rejected.
    const std::uint32_t rejected_below = (0u - bound) % bound;
    std::uint64_t product = 0;
    do
      product = std::uint64_t (bits()) * bound;
    while (std::uint32_t (product) < rejected_below);
    return std::uint32_t (product >> 32);
  }

  /** \brief Uniform in [0, 1), from 32 random bits. */
  double
  unit ()
  {
    constexpr double two_to_32 = 4294967296.0;
    return bits() * (1.0 / two_to_32);
  }

  /** \brief Uniform in [lower, upper). */
  double
  between (double lower, double upper)
  {
    return lower + (upper - lower) * unit();
  }

  /** \brief Uniform angle in [lower, upper).
   * \param[in] lower_degrees, upper_degrees bounds [degrees]
   * \return the angle [rad] */
  double
  angle (double lower_degrees, double upper_degrees)
  {
    // Not by toRadians, which rounds in another way: scenes of a seed would change.
    return between (lower_degrees, upper_degrees) * pi / 180.0;
  }

  /** \brief True with this probability, 0 to 1. */
  bool
  chance (double probability)
  {
    return unit() < probability;
  }

  /** \brief Draws from the standard normal distribution (Box & Muller 1958). */
  double
  gaussian ()
  {
    const double radius = std::sqrt (-2.0 * std::log (1.0 - unit()));
    return radius * std::cos (2.0 * pi * unit());
  }

  /** \brief Draws a uniform point in a box: first z, then y, then x. For an edge of
   * length 0 no random number is drawn. */
  Eigen::Vector3d
  inBox (const Eigen::Vector3d& lower, const Eigen::Vector3d& upper)
  {
    Eigen::Vector3d drawn = lower;
    for (const int axis : {2, 1, 0})
      if (lower[axis] < upper[axis])
        drawn[axis] = between (lower[axis], upper[axis]);
    return drawn;
  }

private:
  std::mt19937 generator_;
};

} // namespace pcl_ops::apps
