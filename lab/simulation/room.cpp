// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scenes.h"

#include <algorithm>
#include <map>

namespace pcl_ops::simulation {

namespace {

using Eigen::AlignedBox2d;

/** Draws a wall, with a window niche or a door set back in it by the given chance. */
Body
drawWall (const WallRange& wall, double chance_of_opening, Random& random)
{
  constexpr double threshold_height = 0.02; // of a door [m]
  Body body;
  if (chance_of_opening <= 0.0 || !random.chance (chance_of_opening)) {
    body.addSurface (wall.at (0.0));
    return body;
  }
  const bool door = random.chance (0.4);
  const double width = door ? 0.9 : random.between (0.9, 1.7);
  const double reach = 0.5 * (wall.right - wall.left - width) - 0.2;
  const double middle = random.between (-reach, reach);
  const double bottom = door ? threshold_height : random.between (0.8, 1.0);
  const double top = door ? 2.05 : random.between (1.9, 2.2);
  const double depth = door ? random.between (0.07, 0.15) : random.between (0.12, 0.3);
  body.addWallAround (
      wall, {middle - 0.5 * width, middle + 0.5 * width, bottom, top}, depth);
  return body;
}

/** Draws a room, then places pieces one by one where the floor is still free. */
struct Furnisher {
  Random random;
  int walls; // how many of the four walls the room has, from wall 0 on
  Site room = {};
  std::vector<AlignedBox2d> occupied = {}; // floor below the pieces

  /** \param[in] smallest, largest length, width and height [m] */
  void
  build (const Vector3d& smallest,
         const Vector3d& largest,
         bool has_ceiling,
         double chance_of_opening)
  {
    for (int axis = 0; axis < 3; ++axis)
      room.size[axis] = random.between (smallest[axis], largest[axis]);
    room.yaw = random.angle (0, 90);
    Body shell;
    const Vector3d length (room.size.x(), 0, 0);
    const Vector3d width (0, room.size.y(), 0);
    shell.addSurface (makeRectangle ({0, 0, 0}, length, width));
    if (has_ceiling)
      shell.addSurface (makeRectangle ({0, 0, room.size.z()}, length, width));
    for (int wall = 0; wall < walls; ++wall) {
      const double half = 0.5 * room.size[wall % 2];
      shell.addPart (
          drawWall ({-half, half, 0.0, room.size.z()}, chance_of_opening, random),
          poseAtWall (wall, 0.0, 0.0));
    }
    room.scene.add (shell, turnZ (room.yaw));
  }

  /** \param[in] along distance from the middle of the wall along it [m]
   * \param[in] gap distance from the wall's plane [m] */
  Isometry3d
  poseAtWall (int wall, double along, double gap) const
  {
    const double to_wall = 0.5 * room.size[(wall + 1) % 2];
    return turnZ (0.5 * pi * wall) * at ({along, gap - to_wall, 0});
  }

  void
  placeAtWall (const Body& piece)
  {
    place (piece, [&] {
      const int wall = int (random.below (std::uint32_t (walls)));
      const double reach = 0.5 * (room.size[wall % 2] - piece.footprint.x());
      const double along = random.between (-reach, reach);
      const double gap = random.between (0.005, 0.05);
      return poseAtWall (wall, along, gap + 0.5 * piece.footprint.y());
    });
  }

  void
  placeAnywhere (const Body& piece)
  {
    place (piece, [&] {
      const double x = random.between (-0.5, 0.5) * room.size.x();
      const double y = random.between (-0.5, 0.5) * room.size.y();
      return at ({x, y, 0}) * turnZ (random.angle (0, 360));
    });
  }

  template <typename DrawPose>
  void
  place (const Body& piece, const DrawPose& drawPose)
  {
    constexpr int attempts = 30;
    for (int attempt = 0; attempt < attempts; ++attempt) {
      const Isometry3d pose = drawPose();
      if (occupy (piece.footprint, pose)) {
        room.scene.add (piece, turnZ (room.yaw) * pose);
        return;
      }
    }
  }

  /** Marks the floor that a piece covers as occupied.
   * \return false if it is not free or not inside the room */
  bool
  occupy (const Vector2d& footprint, const Isometry3d& pose)
  {
    constexpr double clearance = 0.1; // between two pieces, to walk [m]
    AlignedBox2d covered;
    for (const double x : {-0.5, 0.5})
      for (const double y : {-0.5, 0.5}) {
        const Vector3d corner (x * footprint.x(), y * footprint.y(), 0);
        covered.extend (Vector2d ((pose * corner).head<2>()));
      }
    const Vector2d half = 0.5 * room.size.head<2>();
    if (!AlignedBox2d (-half, half).contains (covered))
      return false;
    for (const AlignedBox2d& other : occupied)
      if (other.exteriorDistance (covered) < clearance)
        return false;
    occupied.push_back (covered);
    return true;
  }
};

constexpr double whole_turn = 2.0 * pi;

/** Returns the pose of an upright camera.
 * \param[in] level horizontal unit vector in which the camera looks */
Isometry3d
upright (const Vector3d& eye, const Vector3d& level)
{
  Isometry3d pose = at (eye);
  pose.linear() << level.cross (Vector3d::UnitZ()), -Vector3d::UnitZ(), level;
  return pose;
}

using Way = std::function<Isometry3d (double share)>;

Way
drawWayAround (const Site& room, Random& random)
{
  constexpr double steps = 16.0;
  constexpr double rise = 0.03; // rise [m]
  constexpr double sway = 2.0 * pi / 180.0;
  const double start = random.between (0.0, whole_turn);
  const double turn = (random.chance (0.5) ? 0.75 : -0.75) * whole_turn;
  const double radius = random.between (0.35, 0.6); // of the way to the walls
  const double height = random.between (1.4, 1.8);
  const double pitch = random.angle (8, 18);
  return [=, &room] (double share) -> Isometry3d {
    const double angle = start + share * turn;
    const double step = share * steps * whole_turn;
    const Vector3d eye (0.5 * radius * room.size.x() * std::cos (angle),
                        0.5 * radius * room.size.y() * std::sin (angle),
                        height + rise * std::sin (step));
    const Vector3d level = Vector3d (-eye.x(), -eye.y(), 0.0).normalized();
    return turnZ (room.yaw) * upright (eye, level) * turnX (-pitch) *
           turnZ (sway * std::sin (0.5 * step));
  };
}

Poses
posesOn (const Way& way, std::size_t frames)
{
  Poses poses;
  for (std::size_t i = 0; i < frames; ++i)
    poses.push_back (way (frames == 1 ? 0.0 : double (i) / double (frames - 1)));
  return poses;
}

/** Draws some ways and chooses the one whose worst view shows the most surfaces, the
 * first among equals. \return poses of the frames on it */
Poses
drawBest (const Site& room,
          int ways,
          std::size_t views,
          std::size_t frames,
          const std::function<Way()>& draw)
{
  Way best;
  int most = -1;
  for (int i = 0; i < ways; ++i) {
    const Way way = draw();
    int fewest = std::numeric_limits<int>::max();
    for (const Isometry3d& pose : posesOn (way, views))
      fewest = std::min (fewest, countVisibleSurfaces (room.scene, pose));
    if (fewest > most) {
      best = way;
      most = fewest;
    }
  }
  return posesOn (best, frames);
}

} // namespace

Site
makeRoom (Seed seed)
{
  // Floor area per two further pieces, one at a wall and one anywhere [m^2].
  constexpr double floor_of_piece = 8.0;
  Furnisher furnisher{randomFor (Purpose::Room, seed), 4};
  Random& random = furnisher.random;
  furnisher.build ({3.5, 3.0, 2.4}, {8.0, 6.0, 3.0}, true, 0.6);
  furnisher.placeAtWall (drawLeaningBoard (random));
  furnisher.placeAnywhere (drawRamp (random));
  furnisher.placeAnywhere (drawRoundClutter (random));
  const Vector3d& size = furnisher.room.size;
  const int rounds = int (3.0 + size.x() * size.y() / floor_of_piece);
  for (int i = 0; i < rounds; ++i) {
    furnisher.placeAtWall (drawAtWall (random));
    furnisher.placeAnywhere (drawAnywhere (random));
  }
  return furnisher.room;
}

Site
makeFurnishedCorner (Seed seed)
{
  Furnisher furnisher{randomFor (Purpose::Corner, seed), 2};
  furnisher.build ({3.0, 3.0, 2.4}, {4.0, 4.0, 3.0}, false, 0.0);
  for (const auto draw : {drawBoardRack, drawBoardTable, drawBoardBench})
    furnisher.placeAtWall (draw (furnisher.random));
  for (const auto draw : {drawBoardTable, drawBoardBench})
    furnisher.placeAnywhere (draw (furnisher.random));
  return furnisher.room;
}

int
countVisibleSurfaces (const Scene& scene, const Isometry3d& pose)
{
  constexpr int pixels_of_surface = 5;
  constexpr double closest_object = 0.7; // along the camera's axis [m]
  const DepthImage glance = castDepthImage (scene, {48, 36}, pose);
  if (glance.depth.minCoeff() < closest_object)
    return 0;
  std::map<SurfaceId, int> pixels;
  for (const SurfaceId surface : glance.surface)
    ++pixels[surface];
  int visible = 0;
  for (const auto& [surface, count] : pixels)
    visible += surface != no_surface && count >= pixels_of_surface;
  return visible;
}

Isometry3d
drawCameraPose (const Site& room, Seed seed)
{
  Random random = randomFor (Purpose::CameraPose, seed);
  const auto draw = [&] () -> Way {
    constexpr double wall_distance = 0.4; // [m]
    Vector3d reach = 0.5 * room.size - Vector3d::Constant (wall_distance);
    reach.z() = 1.0;
    // The camera looks from anywhere across the room's middle, somewhat downwards.
    const Vector3d eye = random.inBox ({-1, -1, 1.1}, {1, 1, 1.8}).cwiseProduct (reach);
    Vector3d target =
        random.inBox ({-0.4, -0.4, 0}, {0.4, 0.4, 0}).cwiseProduct (reach);
    target.z() = eye.z();
    const double roll = random.angle (-4, 4);
    const double pitch = random.angle (-20, -5);
    const Isometry3d level = upright (eye, (target - eye).normalized());
    const Isometry3d pose = turnZ (room.yaw) * level * turnX (pitch) * turnZ (roll);
    return [pose] (double) { return pose; };
  };
  return drawBest (room, 32, 1, 1, draw).front();
}

Poses
drawWalk (const Site& room, std::size_t frames, Seed seed)
{
  Random random = randomFor (Purpose::Walk, seed);
  return drawBest (room, 8, 12, frames, [&] { return drawWayAround (room, random); });
}

} // namespace pcl_ops::simulation
