// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_ops/buildings/floor_plan.h>
#include <pcl_ops/buildings/plane_kinds.h>
#include <pcl_ops/buildings/plane_regularization.h>

#include <cstdio>
#include <vector>

// Tests that the functions can be linked. Without planes there are no kinds, and the
// floor plan has no walls.
int
main ()
{
  const pcl_ops::RegularizedPlanes regularized = pcl_ops::regularizePlanes ({});
  const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  const std::vector<pcl_ops::PlaneKind> kinds =
      pcl_ops::planeKinds (regularized.planes, {}, up);
  const pcl_ops::FloorPlan plan =
      pcl_ops::findFloorPlan (pcl_ops::CloudView(), regularized.planes, kinds, up);
  std::printf ("%zu walls\n", plan.walls.size());
  return plan.walls.empty() ? 0 : 1;
}
