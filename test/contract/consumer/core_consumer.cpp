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

// A floor and a wall of 2 m x 2 m, which meet at an edge: a point every 2 cm. Calls no
// library of PCL.
int
main ()
{
  std::vector<TimedPoint> points;
  for (int row = 0; row < 100; ++row)
    for (int column = 0; column < 100; ++column) {
      const float from_edge = 0.02f * static_cast<float> (row + 1);
      const float along_edge = 0.02f * static_cast<float> (column);
      points.push_back ({0.1 * row, from_edge, along_edge, 0.0f});
      points.push_back ({0.1 * row, 0.0f, along_edge, from_edge});
    }
  const pcl_ops::CloudView cloud (
      points.data(), offsetof (TimedPoint, x), sizeof (TimedPoint), points.size());
  const auto planes =
      pcl_ops::detectPlanes (cloud, pcl_ops::OrientedPointSamplingParameters());
  std::printf ("%zu planes\n", planes.size());
  return planes.size() == 2 ? 0 : 1;
}
