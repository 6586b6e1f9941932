// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene.h"

namespace pcl_ops::simulation {

/** Hills as the sum of long and short waves in different directions. */
struct Relief {
  double amplitude = 0.0;             // of the longer waves; 0: flat [m]
  double length = 180.0;              // of the longer waves [m]
  Vector3d phases = Vector3d::Zero(); // [rad]

  double
  height (double x, double y) const
  {
    // The wave lengths differ, so that hills do not repeat.
    constexpr double longer_along_y = 1.3;
    constexpr double length_of_short_waves = 0.5; // share of the long waves' length
    constexpr double height_of_short_waves = 0.35;
    const double turns = 2.0 * pi / length;
    const double long_waves = std::sin (turns * x + phases[0]) *
                              std::cos (turns / longer_along_y * y + phases[1]);
    const double short_waves =
        std::sin (turns / length_of_short_waves * (x + y) + phases[2]);
    return amplitude * (long_waves + height_of_short_waves * short_waves);
  }
};

inline Relief
drawRelief (double amplitude, double length, Random& random)
{
  Relief relief{amplitude, length};
  for (double& phase : relief.phases)
    phase = random.angle (0, 360);
  return relief;
}

} // namespace pcl_ops::simulation
