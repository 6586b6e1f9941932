// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "missing.h"

#include <iterator>

namespace pcl_ops::simulation {

double
missingShare (Seed seed)
{
  constexpr double shares[] = {0.01, 0.03, 0.05, 0.1, 0.2, 0.4, 0.5};
  // Seed 1 has the first share. The size is added so that seed 0 has the last one.
  const std::size_t number = std::size_t (seed) + std::size (shares) - 1;
  return shares[number % std::size (shares)];
}

void
zeroReadings (Scan& scan, double share, Seed seed)
{
  Random random = randomFor (Purpose::Missing, seed);
  std::size_t readings_left = 0;
  for (const Vector3d& point : scan.points)
    readings_left += std::isfinite (point.x());
  double zeros_left = std::round (share * double (readings_left));
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    if (!std::isfinite (scan.points[i].x()))
      continue;
    // Selection sampling chooses exactly the wanted number (Knuth, The Art of Computer
    // Programming 2, algorithm S).
    if (random.unit() * double (readings_left) < zeros_left) {
      scan.points[i] = Vector3d::Zero();
      scan.surfaces[i] = no_surface;
      zeros_left -= 1.0;
    }
    --readings_left;
  }
}

} // namespace pcl_ops::simulation
