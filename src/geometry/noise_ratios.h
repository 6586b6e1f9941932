// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

namespace pcl_ops::internal {

// Both ratios were chosen by hand: src/doc/constants.csv has the accuracy with others.

/** \brief Largest ratio of two noises that count as alike, as of one surface. */
inline constexpr double like_noise_ratio = 1.5;

/** \brief Two noises with a ratio above this are of different surfaces. */
inline constexpr double other_noise_ratio = 6.0;

/** \brief Returns the squared noise of a plane [m^2], limited to the square of \ref
 * other_noise_ratio times the squared noise of the plane that it is compared with. So
 * the noise of a bush does not explain how far its points are from the ground, which
 * has little noise. */
inline double
commonSquaredNoise (double squared_noise, double squared_noise_of_other)
{
  return std::min (squared_noise,
                   other_noise_ratio * other_noise_ratio * squared_noise_of_other);
}

} // namespace pcl_ops::internal
