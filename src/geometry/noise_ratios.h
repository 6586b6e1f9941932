// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

namespace pcl_ops::internal {

/** \brief Largest ratio of two noises that count as alike, as of one surface. */
inline constexpr double like_noise = 1.5;

/** \brief Two noises with a ratio above this are of different surfaces. */
inline constexpr double other_noise = 6.0;

/** \brief Returns a plane's squared noise, limited to \ref other_noise ^2 times that of
 * the plane it is compared with [m^2]. So the noise of a bush does not explain how far
 * its points are from the clean ground. */
inline double
commonSquaredNoise (double squared_noise, double squared_noise_of_other)
{
  return std::min (squared_noise, other_noise * other_noise * squared_noise_of_other);
}

} // namespace pcl_ops::internal
