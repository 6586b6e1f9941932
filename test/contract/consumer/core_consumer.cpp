// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_ops/detect_planes.h>

#include <cstddef>
#include <cstdio>
#include <vector>

// A point as a sensor's driver provides it: a time stamp before the position [m].
struct TimedPoint {
  double seconds;
  float x, y, z;
};

// A floor and a wall of 2 m x 2 m, which meet at an edge.
static std::vector<TimedPoint>
floorAndWall ()
{
  constexpr float spacing = 0.02f; // [m]
  constexpr double seconds_per_row = 0.1;
  std::vector<TimedPoint> points;
  for (int row = 0; row < 100; ++row)
    for (int column = 0; column < 100; ++column) {
      const double seconds = seconds_per_row * row;
      const float from_edge = spacing * static_cast<float> (row + 1);
      const float along_edge = spacing * static_cast<float> (column);
      points.push_back ({seconds, from_edge, along_edge, 0.0f});
      points.push_back ({seconds, 0.0f, along_edge, from_edge});
    }
  return points;
}

// Uses pcl_ops::core, which needs no library of PCL.
int
main ()
{
  const std::vector<TimedPoint> points = floorAndWall();
  const pcl_ops::CloudView cloud (
      points.data(), offsetof (TimedPoint, x), sizeof (TimedPoint), points.size());
  const std::vector<pcl_ops::PlaneSegment> planes =
      pcl_ops::detectPlanes (cloud, pcl_ops::OrientedPointSamplingParameters());
  std::printf ("%zu planes\n", planes.size());
  return planes.size() == 2 ? 0 : 1;
}
