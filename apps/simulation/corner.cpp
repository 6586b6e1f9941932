// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "corner.h"

#include "board_furniture.h"
#include "furnisher.h"
#include "poses.h"
#include "room_shell.h"

namespace pcl_ops::simulation {

Room
makeFurnishedCorner (std::uint32_t seed)
{
  internal::RandomGenerator generator = makeGenerator (seed, Purpose::Corner);
  Room corner;
  corner.size = {drawBetween (generator, 3.0, 4.0),
                 drawBetween (generator, 3.0, 4.0),
                 drawBetween (generator, 2.4, 3.0)};
  corner.yaw = drawAngle (generator, 0, 90);
  addBody (corner.scene,
           makeCornerShell (corner.size),
           turned (corner.yaw, Eigen::Vector3d::UnitZ()));
  Furnisher furnisher (corner, corner_walls, generator);
  for (const auto make : {makeBoardRack, makeBoardTable, makeBoardBench})
    furnisher.placeAtWall (make (generator));
  for (const auto make : {makeBoardTable, makeBoardBench})
    furnisher.placeAnywhere (make (generator));
  return corner;
}

} // namespace pcl_ops::simulation
