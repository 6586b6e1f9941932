// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

namespace pcl_ops::internal {

/** \brief How much of a plane's squared noise explains that another plane's points are
 * off it [m^2]: six times the noise of the other at most. A bush explains no distance
 * from a clean ground. */
inline double
commonSquaredNoise (double squared_noise, double squared_noise_of_other)
{
  constexpr double squared_ratio = 6.0 * 6.0;
  return std::min (squared_noise, squared_ratio * squared_noise_of_other);
}

} // namespace pcl_ops::internal
