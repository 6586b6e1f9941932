// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_ops/surface/concave_hull.h>

#include <cstdio>

// Tests that pcl_ops::surface can be linked and run.
int
main ()
{
  const pcl_ops::PlanarPoints square = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const pcl_ops::PlanarRings outer_ring_and_holes = pcl_ops::concaveOutline (square);
  const std::size_t corners = outer_ring_and_holes.front().size();
  std::printf ("%zu corners\n", corners);
  return corners == 4 ? 0 : 1;
}
