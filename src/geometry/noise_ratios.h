// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

namespace pcl_ops::internal {

/** \brief Noise that is up to this many times another is alike: of one surface. */
inline constexpr double like_noise = 1.5;

/** \brief Noise that is more than this many times another is of another surface. */
inline constexpr double other_noise = 6.0;

/** \brief How much of a plane's squared noise explains that another plane's points are
 * off it [m^2]: a bush explains no distance from a clean ground. */
inline double
commonSquaredNoise (double squared_noise, double squared_noise_of_other)
{
  return std::min (squared_noise, other_noise * other_noise * squared_noise_of_other);
}

} // namespace pcl_ops::internal
