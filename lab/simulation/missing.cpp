// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "missing.h"

#include <iterator>

namespace pcl_ops::simulation {

double
missingShare (Seed seed)
{
  constexpr double shares[] = {0.01, 0.03, 0.05, 0.1, 0.2, 0.4, 0.5};
  // Seed 1 has the first share. The number of shares is added so that seed 0 has the
  // last one.
  const std::size_t from_first = std::size_t (seed) + std::size (shares) - 1;
  return shares[from_first % std::size (shares)];
}

void
zeroReadings (Scan& scan, double share, Seed seed)
{
  Random random = randomFor (Purpose::Missing, seed);
  std::size_t remaining_readings = 0;
  for (const Vector3d& point : scan.points)
    remaining_readings += std::isfinite (point.x());
  double remaining_zeros = std::round (share * double (remaining_readings));
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    if (!std::isfinite (scan.points[i].x()))
      continue;
    // Selection sampling chooses exactly that number of zeros (Knuth, The Art of
    // Computer Programming 2, algorithm S).
    if (random.unit() * double (remaining_readings) < remaining_zeros) {
      scan.points[i] = Vector3d::Zero();
      scan.surfaces[i] = no_surface;
      remaining_zeros -= 1.0;
    }
    --remaining_readings;
  }
}

} // namespace pcl_ops::simulation
