// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_ops/detect_planes.h>

#include <cstddef>
#include <cstdio>
#include <vector>

// A point as a driver provides it: a time stamp before the position.
struct TimedPoint {
  double seconds;
  float x, y, z;
};

// Two meters of floor and two meters of wall, a point every 2 cm; no library of PCL.
int
main ()
{
  std::vector<TimedPoint> points;
  for (int row = 0; row < 100; ++row)
    for (int column = 0; column < 100; ++column) {
      const float a = 0.02f * static_cast<float> (row + 1);
      const float b = 0.02f * static_cast<float> (column);
      points.push_back ({0.1 * row, a, b, 0.0f});
      points.push_back ({0.1 * row, 0.0f, b, a});
    }
  const pcl_ops::CloudView cloud (
      points.data(), offsetof (TimedPoint, x), sizeof (TimedPoint), points.size());
  const auto planes =
      pcl_ops::detectPlanes (cloud, pcl_ops::OrientedPointSamplingParameters());
  std::printf ("%zu planes\n", planes.size());
  return planes.size() == 2 ? 0 : 1;
}
