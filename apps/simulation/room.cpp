// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "room.h"

#include "furniture.h"
#include "poses.h"
#include "room_shell.h"
#include "round_furniture.h"
#include "tilted_furniture.h"

#include <vector>

namespace pcl_ops::simulation {

namespace {

using Eigen::AlignedBox2d;
using Eigen::Vector2d;
using Eigen::Vector3d;

using FurnitureMaker = Furniture (*) (internal::RandomGenerator&);

/** \brief Room to walk between two pieces [m]. */
constexpr double clearance = 0.1;
constexpr int placement_attempts = 30;
/** \brief Floor area for each piece at a wall and each in the room [m^2]. */
constexpr double floor_of_piece = 8.0;

struct PlacedFurniture {
  Body body;
  Eigen::Isometry3d pose;
};

/** \brief The part of the floor, parallel to the walls, that a placed piece covers. */
AlignedBox2d
coveredFloor (const Vector2d& footprint, const Eigen::Isometry3d& pose)
{
  AlignedBox2d covered;
  for (const double x : {-0.5, 0.5})
    for (const double y : {-0.5, 0.5}) {
      const Vector3d corner (x * footprint.x(), y * footprint.y(), 0.0);
      covered.extend (Vector2d ((pose * corner).head<2>()));
    }
  return covered;
}

Eigen::Isometry3d
drawPoseAtWall (const Vector3d& room,
                const Vector2d& footprint,
                internal::RandomGenerator& generator)
{
  const int wall = int (internal::drawBelow (generator, 4));
  const double reach = 0.5 * (wallLength (room, wall) - footprint.x());
  const double along = drawBetween (generator, -reach, reach);
  const double gap = drawBetween (generator, 0.005, 0.05);
  return poseAtWall (room, wall, along, gap + 0.5 * footprint.y());
}

Eigen::Isometry3d
drawPoseAnywhere (const Vector3d& room,
                  const Vector2d&,
                  internal::RandomGenerator& generator)
{
  const double x = drawBetween (generator, -0.5, 0.5) * room.x();
  const double y = drawBetween (generator, -0.5, 0.5) * room.y();
  return at (x, y, 0.0) * turned (drawAngle (generator, 0, 360), Vector3d::UnitZ());
}

/** \brief Places pieces one by one where there is still room for them. */
class Furnisher {
public:
  Furnisher (Room& room, internal::RandomGenerator& generator)
  : room_ (room), generator_ (generator)
  {}

  template <typename DrawPose>
  void
  place (const Furniture& furniture, DrawPose drawPose)
  {
    for (int attempt = 0; attempt < placement_attempts; ++attempt) {
      const auto pose = drawPose (room_.size, furniture.footprint, generator_);
      const AlignedBox2d covered = coveredFloor (furniture.footprint, pose);
      if (!isFree (covered))
        continue;
      covered_.push_back (covered);
      addBody (
          room_.scene, furniture.body, turned (room_.yaw, Vector3d::UnitZ()) * pose);
      return;
    }
  }

private:
  bool
  isFree (const AlignedBox2d& covered) const
  {
    const Vector2d half = 0.5 * room_.size.head<2>();
    if (!AlignedBox2d (-half, half).contains (covered))
      return false;
    for (const AlignedBox2d& other : covered_)
      if (other.exteriorDistance (covered) < clearance)
        return false;
    return true;
  }

  Room& room_;
  internal::RandomGenerator& generator_;
  std::vector<AlignedBox2d> covered_;
};

void
furnish (Room& room, internal::RandomGenerator& generator)
{
  constexpr FurnitureMaker at_walls[] = {
      makeDesk, makeCupboard, makeShelf, makeBed, makeSofa, makeLeaningBoard};
  constexpr FurnitureMaker anywhere[] = {
      makeTable, makeChair, makeCartons, makeTiltedPanel, makeRoundClutter};
  Furnisher furnisher (room, generator);
  furnisher.place (makeLeaningBoard (generator), drawPoseAtWall);
  furnisher.place (makeRamp (generator), drawPoseAnywhere);
  furnisher.place (makeRoundClutter (generator), drawPoseAnywhere);
  const double floor_area = room.size.x() * room.size.y();
  const int rounds = int (3.0 + floor_area / floor_of_piece);
  for (int i = 0; i < rounds; ++i) {
    furnisher.place (at_walls[internal::drawBelow (generator, 6)](generator),
                     drawPoseAtWall);
    furnisher.place (anywhere[internal::drawBelow (generator, 5)](generator),
                     drawPoseAnywhere);
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
