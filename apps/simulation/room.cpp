// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "room.h"

#include "furnisher.h"
#include "poses.h"
#include "room_shell.h"
#include "round_furniture.h"
#include "tilted_furniture.h"

namespace pcl_ops::simulation {

namespace {

using Eigen::Vector3d;

using FurnitureMaker = Furniture (*) (internal::RandomGenerator&);

/** \brief Floor area for each piece at a wall and each in the room [m^2]. */
constexpr double floor_of_piece = 8.0;

void
furnish (Room& room, internal::RandomGenerator& generator)
{
  constexpr FurnitureMaker at_walls[] = {
      makeDesk, makeCupboard, makeShelf, makeBed, makeSofa, makeLeaningBoard};
  constexpr FurnitureMaker anywhere[] = {
      makeTable, makeChair, makeCartons, makeTiltedPanel, makeRoundClutter};
  Furnisher furnisher (room, 4, generator);
  furnisher.placeAtWall (makeLeaningBoard (generator));
  furnisher.placeAnywhere (makeRamp (generator));
  furnisher.placeAnywhere (makeRoundClutter (generator));
  const double floor_area = room.size.x() * room.size.y();
  const int rounds = int (3.0 + floor_area / floor_of_piece);
  for (int i = 0; i < rounds; ++i) {
    furnisher.placeAtWall (at_walls[internal::drawBelow (generator, 6)](generator));
    furnisher.placeAnywhere (anywhere[internal::drawBelow (generator, 5)](generator));
  }
}

} // namespace

Room
makeRoom (std::uint32_t seed)
{
  internal::RandomGenerator generator = makeGenerator (seed, Purpose::Room);
  Room room;
  room.size = {drawBetween (generator, 3.5, 8.0),
               drawBetween (generator, 3.0, 6.0),
               drawBetween (generator, 2.4, 3.0)};
  room.yaw = drawAngle (generator, 0, 90);
  addBody (room.scene,
           makeRoomShell (room.size, generator),
           turned (room.yaw, Vector3d::UnitZ()));
  furnish (room, generator);
  return room;
}

} // namespace pcl_ops::simulation
