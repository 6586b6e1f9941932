// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_ops/buildings/floor_plan.h>
#include <pcl_ops/buildings/plane_kinds.h>
#include <pcl_ops/buildings/plane_regularization.h>

#include <cstdio>

// Tests linking only: without planes there are no kinds and the plan is empty.
int
main ()
{
  const pcl_ops::RegularizedPlanes exact = pcl_ops::regularizePlanes ({});
  const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  const auto kinds = pcl_ops::planeKinds (exact.planes, {}, up);
  const pcl_ops::FloorPlan plan =
      pcl_ops::findFloorPlan (pcl_ops::CloudView(), exact.planes, kinds, up);
  std::printf ("%zu walls\n", plan.walls.size());
  return plan.walls.empty() ? 0 : 1;
}
