// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene.h"

namespace pcl_ops::simulation {

/** Hills as the sum of long and short waves in different directions. */
struct Relief {
  double amplitude = 0.0;             // of the long waves; 0: flat ground [m]
  double wave_length = 180.0;         // of the long waves along x [m]
  Vector3d phases = Vector3d::Zero(); // long waves along x, y; short waves [rad]

  /** Returns the height of the ground [m]. */
  double
  height (double x, double y) const
  {
    // Ratios of lengths and heights to those of the long waves along x. The length of
    // the short waves, which run diagonally, is measured along x or y. Hills repeat
    // along x after each wave_length, along y after 6.5 of them.
    constexpr double length_along_y = 1.3;
    constexpr double length_of_short_waves = 0.5;
    constexpr double height_of_short_waves = 0.35;
    const double wave_number = 2.0 * pi / wave_length; // [rad / m]
    const double long_waves = std::sin (wave_number * x + phases[0]) *
                              std::cos (wave_number / length_along_y * y + phases[1]);
    const double short_waves =
        std::sin (wave_number / length_of_short_waves * (x + y) + phases[2]);
    return amplitude * (long_waves + height_of_short_waves * short_waves);
  }
};

/** Draws the phases of hills. */
inline Relief
drawRelief (double amplitude, double wave_length, Random& random)
{
  Relief relief{amplitude, wave_length};
  for (double& phase : relief.phases)
    phase = random.angle (0, 360);
  return relief;
}

} // namespace pcl_ops::simulation
