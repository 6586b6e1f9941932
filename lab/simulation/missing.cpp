// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "missing.h"

#include <iterator>

namespace pcl_ops::simulation {

double
missingShare (Seed seed)
{
  constexpr double shares[] = {0.01, 0.03, 0.05, 0.1, 0.2, 0.4, 0.5};
  return shares[(std::size_t (seed) + std::size (shares) - 1) % std::size (shares)];
}

void
zeroReadings (Scan& scan, double share, Seed seed)
{
  Random random = randomFor (Purpose::Missing, seed);
  std::size_t readings = 0;
  for (const Vector3d& point : scan.points)
    readings += std::isfinite (point.x());
  double wanted = std::round (share * double (readings));
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    if (!std::isfinite (scan.points[i].x()))
      continue;
    // Chooses exactly the wanted number (selection sampling: Knuth 1969, algorithm S).
    if (random.unit() * double (readings) < wanted) {
      scan.points[i] = Vector3d::Zero();
      scan.surfaces[i] = no_surface;
      wanted -= 1.0;
    }
    --readings;
  }
}

} // namespace pcl_ops::simulation
