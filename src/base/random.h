// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <random>

namespace pcl_ops::internal {

/** \brief The generator of all random numbers of the library. The C++ standard fixes
 * the output of std::mt19937, but not that of the std:: distributions: the functions
 * below replace these distributions. */
using RandomGenerator = std::mt19937;

/** \brief Returns an unbiased draw from 0 .. bound - 1; 0 for bound 0 (D. Lemire, "Fast
 * Random Integer Generation in an Interval", 2019: multiply and reject). */
inline std::uint32_t
drawBelow (RandomGenerator& generator, std::uint32_t bound)
{
  if (bound < 2)
    return 0;
  const std::uint32_t rejected_below = (0u - bound) % bound; // 2^32 modulo bound
  std::uint64_t product = 0;
  do
    product = std::uint64_t (generator()) * bound;
  while (std::uint32_t (product) < rejected_below);
  return std::uint32_t (product >> 32);
}

/** \brief Returns a uniform draw from [0, 1) with 32 random bits. */
inline double
drawUnit (RandomGenerator& generator)
{
  constexpr double two_to_the_32 = 4294967296.0;
  return generator() * (1.0 / two_to_the_32);
}

} // namespace pcl_ops::internal
