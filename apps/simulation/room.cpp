// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "room.h"

#include "furniture.h"

namespace pcl_ops::simulation {

namespace {

using Eigen::AlignedBox2d;
using Eigen::Isometry3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int walls_of_room = 4, walls_of_corner = 2;

/** \brief Length of a wall, 0 to 3 [m]. */
double
wallLength (const Vector3d& size, int wall)
{
  return wall % 2 == 0 ? size.x() : size.y();
}

/** \brief Puts what stands at the origin with its back towards -y against a wall.
 * \param[in] size of the room [m]
 * \param[in] wall 0 to 3
 * \param[in] along shift along the wall from its middle [m]
 * \param[in] gap from the wall's plane [m] */
Isometry3d
poseAtWall (const Vector3d& size, int wall, double along, double gap)
{
  const double to_wall = 0.5 * wallLength (size, wall + 1);
  return turnZ (0.5 * pi * wall) * at (along, gap - to_wall, 0.0);
}

/** \brief A wall, maybe with a window niche or a door whose leaf is set back. */
Body
drawWall (const WallRange& wall, double chance_of_opening, Random& random)
{
  constexpr double threshold_height = 0.02; // of a door [m]
  Body body;
  if (chance_of_opening <= 0.0 || !random.chance (chance_of_opening)) {
    addSurface (body, wall.at (0.0));
    return body;
  }
  const bool door = random.chance (0.4);
  const double width = door ? 0.9 : random.between (0.9, 1.7);
  const double reach = 0.5 * (wall.right - wall.left - width) - 0.2;
  const double middle = random.between (-reach, reach);
  const double bottom = door ? threshold_height : random.between (0.8, 1.0);
  const double top = door ? 2.05 : random.between (1.9, 2.2);
  const double depth = door ? random.between (0.07, 0.15) : random.between (0.12, 0.3);
  addWallAround (
      body, wall, {middle - 0.5 * width, middle + 0.5 * width, bottom, top}, depth);
  return body;
}

/** \brief The floor, the ceiling and the walls of an empty room.
 * \param[in] size length, width and height [m] */
Body
drawShell (const Vector3d& size,
           const std::vector<double>& levels,
           int walls,
           double chance_of_opening,
           Random& random)
{
  Body shell;
  const double half_x = 0.5 * size.x(), half_y = 0.5 * size.y();
  for (const double z : levels)
    addSurface (shell, rectangleAlong (0, 1, {0, 0, z}, half_x, half_y));
  for (int wall = 0; wall < walls; ++wall) {
    const double half_length = 0.5 * wallLength (size, wall);
    const WallRange range{-half_length, half_length, 0.0, size.z()};
    addPart (shell,
             drawWall (range, chance_of_opening, random),
             poseAtWall (size, wall, 0.0, 0.0));
  }
  return shell;
}

/** \brief Places pieces of furniture one by one where there is still room for them;
 * those for which there is none are left out. */
struct Furnisher {
  Room& room;
  /** \brief The first of the four that the room has. */
  int walls;
  Random& random;
  /** \brief The floor below the pieces. */
  std::vector<AlignedBox2d> occupied = {};

  /** \brief With its back to some wall. */
  void
  placeAtWall (const Furniture& furniture)
  {
    const Vector2d& footprint = furniture.footprint;
    place (furniture, [&] {
      const int wall = int (random.below (std::uint32_t (walls)));
      const double reach = 0.5 * (wallLength (room.size, wall) - footprint.x());
      const double along = random.between (-reach, reach);
      const double gap = random.between (0.005, 0.05);
      return poseAtWall (room.size, wall, along, gap + 0.5 * footprint.y());
    });
  }

  /** \brief Anywhere in the room, turned in any way. */
  void
  placeAnywhere (const Furniture& furniture)
  {
    place (furniture, [&] {
      const double x = random.between (-0.5, 0.5) * room.size.x();
      const double y = random.between (-0.5, 0.5) * room.size.y();
      return at (x, y, 0.0) * turnZ (random.angle (0, 360));
    });
  }

  template <typename DrawPose>
  void
  place (const Furniture& furniture, const DrawPose& drawPose)
  {
    constexpr int attempts = 30;
    for (int attempt = 0; attempt < attempts; ++attempt) {
      const Isometry3d pose = drawPose();
      const AlignedBox2d covered = coveredFloor (furniture.footprint, pose);
      if (!isFree (covered))
        continue;
      occupied.push_back (covered);
      addBody (room.scene, furniture.body, turnZ (room.yaw) * pose);
      return;
    }
  }

  /** \brief The part of the floor, parallel to the walls, that a piece covers. */
  static AlignedBox2d
  coveredFloor (const Vector2d& footprint, const Isometry3d& pose)
  {
    AlignedBox2d covered;
    for (const double x : {-0.5, 0.5})
      for (const double y : {-0.5, 0.5}) {
        const Vector3d corner (x * footprint.x(), y * footprint.y(), 0.0);
        covered.extend (Vector2d ((pose * corner).head<2>()));
      }
    return covered;
  }

  bool
  isFree (const AlignedBox2d& covered) const
  {
    constexpr double clearance = 0.1; // between two pieces, to walk [m]
    const Vector2d half = 0.5 * room.size.head<2>();
    if (!AlignedBox2d (-half, half).contains (covered))
      return false;
    for (const AlignedBox2d& other : occupied)
      if (other.exteriorDistance (covered) < clearance)
        return false;
    return true;
  }
};

void
furnish (Room& room, Random& random)
{
  constexpr double floor_of_piece =
      8.0; // for each at a wall and each in the room [m^2]
  Furnisher furnisher{room, walls_of_room, random};
  furnisher.placeAtWall (drawLeaningBoard (random));
  furnisher.placeAnywhere (drawRamp (random));
  furnisher.placeAnywhere (drawRoundClutter (random));
  const int rounds = int (3.0 + room.size.x() * room.size.y() / floor_of_piece);
  for (int i = 0; i < rounds; ++i) {
    furnisher.placeAtWall (drawAtWall (random));
    furnisher.placeAnywhere (drawAnywhere (random));
  }
}

/** \brief An empty scene of a drawn size and direction.
 * \param[in] smallest, largest length, width and height [m] */
Room
drawRoomSize (const Vector3d& smallest, const Vector3d& largest, Random& random)
{
  Room room;
  for (int axis = 0; axis < 3; ++axis)
    room.size[axis] = random.between (smallest[axis], largest[axis]);
  room.yaw = random.angle (0, 90);
  return room;
}

} // namespace

Room
makeRoom (std::uint32_t seed)
{
  Random random = randomFor (Purpose::Room, seed);
  Room room = drawRoomSize ({3.5, 3.0, 2.4}, {8.0, 6.0, 3.0}, random);
  const Body shell =
      drawShell (room.size, {0.0, room.size.z()}, walls_of_room, 0.6, random);
  addBody (room.scene, shell, turnZ (room.yaw));
  furnish (room, random);
  return room;
}

Room
makeFurnishedCorner (std::uint32_t seed)
{
  Random random = randomFor (Purpose::Corner, seed);
  Room corner = drawRoomSize ({3.0, 3.0, 2.4}, {4.0, 4.0, 3.0}, random);
  const Body shell = drawShell (corner.size, {0.0}, walls_of_corner, 0.0, random);
  addBody (corner.scene, shell, turnZ (corner.yaw));
  Furnisher furnisher{corner, walls_of_corner, random};
  for (const auto draw : {drawBoardRack, drawBoardTable, drawBoardBench})
    furnisher.placeAtWall (draw (random));
  for (const auto draw : {drawBoardTable, drawBoardBench})
    furnisher.placeAnywhere (draw (random));
  return corner;
}

} // namespace pcl_ops::simulation
