// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scenes.h"

#include <algorithm>
#include <map>

namespace pcl_ops::simulation {

namespace {

using Eigen::AlignedBox2d;

/** Draws a wall and, with the given chance, a window or a door that is set back in it.
 */
Body
drawWall (const WallRange& wall, double chance_of_opening, Random& random)
{
  constexpr double threshold_height = 0.02; // from the floor to the door [m]
  constexpr double beside = 0.2;            // least wall on each side [m]
  Body body;
  if (chance_of_opening <= 0.0 || !random.chance (chance_of_opening)) {
    body.addSurface (wall.rectangleAt (0.0));
    return body;
  }
  // Common lengths and heights of doors and windows [m].
  const bool is_door = random.chance (0.4);
  const double width = is_door ? 0.9 : random.between (0.9, 1.7);
  // Largest distance of the opening's middle from the middle of the wall [m].
  const double reach = 0.5 * (wall.right - wall.left - width) - beside;
  const double middle = random.between (-reach, reach);
  const double bottom = is_door ? threshold_height : random.between (0.8, 1.0);
  const double top = is_door ? 2.05 : random.between (1.9, 2.2);
  const double depth =
      is_door ? random.between (0.07, 0.15) : random.between (0.12, 0.3);
  body.addWallAround (
      wall, {middle - 0.5 * width, middle + 0.5 * width, bottom, top}, depth);
  return body;
}

/** The range of rooms from which a room is drawn. */
struct RoomKind {
  Vector3d smallest, largest; // length, width and height [m]
  int walls = 4;              // number of walls; 2: the two walls of a corner
  bool has_ceiling = false;
  double chance_of_opening = 0.0; // chance of a window or a door in each wall
};

/** Draws a room, then places pieces one by one where the floor is still free. */
struct Furnisher {
  Random random;
  RoomKind kind;
  Site room = {};
  /** The floor below the pieces, in the frame of the room. */
  std::vector<AlignedBox2d> occupied = {};

  void
  drawShell ()
  {
    for (int axis = 0; axis < 3; ++axis)
      room.size[axis] = random.between (kind.smallest[axis], kind.largest[axis]);
    room.yaw = random.angle (0, 90);
    Body shell;
    const Vector3d length (room.size.x(), 0, 0);
    const Vector3d width (0, room.size.y(), 0);
    shell.addSurface (makeRectangle ({0, 0, 0}, length, width));
    if (kind.has_ceiling)
      shell.addSurface (makeRectangle ({0, 0, room.size.z()}, length, width));
    for (int wall = 0; wall < kind.walls; ++wall) {
      const double half = 0.5 * lengthOfWall (wall);
      shell.addPart (
          drawWall ({-half, half, 0.0, room.size.z()}, kind.chance_of_opening, random),
          poseAtWall (wall, 0.0, 0.0));
    }
    room.scene.add (shell, turnZ (room.yaw));
  }

  /** Walls 0 and 2 are along the length of the room, 1 and 3 along its width. */
  double
  lengthOfWall (int wall) const
  {
    return room.size[wall % 2];
  }

  /** Returns a pose at a wall whose y axis looks into the room.
   * \param[in] along distance from the middle of the wall along it [m]
   * \param[in] gap distance from the wall's plane [m] */
  Isometry3d
  poseAtWall (int wall, double along, double gap) const
  {
    const double middle_to_wall = 0.5 * lengthOfWall (wall + 1);
    return turnZ (0.5 * pi * wall) * at ({along, gap - middle_to_wall, 0});
  }

  /** Places a piece with its back at a wall, almost touching it. */
  void
  placeAtWall (const Body& piece)
  {
    place (piece, [&] {
      const int wall = int (random.below (std::uint32_t (kind.walls)));
      const double reach = 0.5 * (lengthOfWall (wall) - piece.footprint.x());
      const double along = random.between (-reach, reach);
      const double gap = random.between (0.005, 0.05);
      return poseAtWall (wall, along, gap + 0.5 * piece.footprint.y());
    });
  }

  /** Places a piece anywhere on the floor, with any yaw. */
  void
  placeAnywhere (const Body& piece)
  {
    place (piece, [&] {
      const double x = random.between (-0.5, 0.5) * room.size.x();
      const double y = random.between (-0.5, 0.5) * room.size.y();
      return at ({x, y, 0}) * turnZ (random.angle (0, 360));
    });
  }

  /** Draws poses until the piece stands on free floor. The room gets no such piece if
   * that is true of none of 30 poses. */
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
   * \return false if the floor is not free or not inside the room */
  bool
  occupy (const Vector2d& footprint, const Isometry3d& pose)
  {
    constexpr double clearance = 0.1; // least distance of two pieces [m]
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
 * \param[in] forward horizontal unit vector: the direction in which the camera looks */
Isometry3d
upright (const Vector3d& eye, const Vector3d& forward)
{
  Isometry3d pose = at (eye);
  pose.linear() << forward.cross (Vector3d::UnitZ()), -Vector3d::UnitZ(), forward;
  return pose;
}

/** The camera pose on a path at a share of its length, from 0 to 1. */
using CameraPath = std::function<Isometry3d (double share)>;

/** Draws the path of a person who walks around the middle of a room. The path refers to
 * the room, which must outlive it. */
CameraPath
drawPathAround (const Site& room, Random& random)
{
  constexpr double steps = 16.0;            // of the person, on the whole path
  constexpr double rise = 0.03;             // amplitude over each step [m]
  constexpr double sway = 2.0 * pi / 180.0; // amplitude of the roll [rad]
  const double start = random.between (0.0, whole_turn);
  const double angle_of_path = (random.chance (0.5) ? 0.75 : -0.75) * whole_turn;
  // As a share of the distance from the middle of the room to the walls.
  const double radius = random.between (0.35, 0.6);
  const double height = random.between (1.4, 1.8); // [m]
  const double pitch = random.angle (8, 18);
  return [=, &room] (double share) -> Isometry3d {
    const double angle = start + share * angle_of_path;
    const double step = share * steps * whole_turn; // phase of the steps [rad]
    const Vector3d eye (0.5 * radius * room.size.x() * std::cos (angle),
                        0.5 * radius * room.size.y() * std::sin (angle),
                        height + rise * std::sin (step));
    const Vector3d forward = Vector3d (-eye.x(), -eye.y(), 0.0).normalized();
    return turnZ (room.yaw) * upright (eye, forward) * turnX (-pitch) *
           turnZ (sway * std::sin (0.5 * step));
  };
}

/** Returns poses in equal steps from the begin of a path to its end; a single pose is
 * at its begin. */
Poses
posesOn (const CameraPath& path, std::size_t frames)
{
  Poses poses;
  for (std::size_t i = 0; i < frames; ++i)
    poses.push_back (path (frames == 1 ? 0.0 : double (i) / double (frames - 1)));
  return poses;
}

/** The effort of \ref drawBestPath. */
struct PathSearch {
  int paths;         // number of paths that are drawn
  std::size_t views; // number of poses on each path from which surfaces are counted
};

/** Draws some paths and chooses the one whose worst view shows the most surfaces, the
 * first among equals. */
CameraPath
drawBestPath (const Site& room,
              const PathSearch& search,
              const std::function<CameraPath()>& draw)
{
  CameraPath best;
  int most_surfaces = -1;
  for (int i = 0; i < search.paths; ++i) {
    const CameraPath path = draw();
    int fewest_surfaces = std::numeric_limits<int>::max();
    for (const Isometry3d& pose : posesOn (path, search.views))
      fewest_surfaces =
          std::min (fewest_surfaces, countVisibleSurfaces (room.scene, pose));
    if (fewest_surfaces > most_surfaces) {
      best = path;
      most_surfaces = fewest_surfaces;
    }
  }
  return best;
}

} // namespace

Site
makeRoom (Seed seed)
{
  // Two pieces, one at a wall and one anywhere, are drawn three times, and once more
  // for each part of the floor of this area [m^2].
  constexpr double area_per_pair = 8.0;
  constexpr double pairs_in_any_room = 3.0;
  RoomKind kind{{3.5, 3.0, 2.4}, {8.0, 6.0, 3.0}};
  kind.walls = 4;
  kind.has_ceiling = true;
  kind.chance_of_opening = 0.6;
  Furnisher furnisher{randomFor (Purpose::Room, seed), kind};
  Random& random = furnisher.random;
  furnisher.drawShell();
  furnisher.placeAtWall (drawLeaningBoard (random));
  furnisher.placeAnywhere (drawRamp (random));
  furnisher.placeAnywhere (drawRoundClutter (random));
  const Vector3d& size = furnisher.room.size;
  const int pairs = int (pairs_in_any_room + size.x() * size.y() / area_per_pair);
  for (int i = 0; i < pairs; ++i) {
    furnisher.placeAtWall (drawAtWall (random));
    furnisher.placeAnywhere (drawAnywhere (random));
  }
  return furnisher.room;
}

Site
makeFurnishedCorner (Seed seed)
{
  RoomKind kind{{3.0, 3.0, 2.4}, {4.0, 4.0, 3.0}};
  kind.walls = 2;
  Furnisher furnisher{randomFor (Purpose::Corner, seed), kind};
  furnisher.drawShell();
  for (const auto draw : {drawBoardRack, drawBoardTable, drawBoardBench})
    furnisher.placeAtWall (draw (furnisher.random));
  for (const auto draw : {drawBoardTable, drawBoardBench})
    furnisher.placeAnywhere (draw (furnisher.random));
  return furnisher.room;
}

int
countVisibleSurfaces (const Scene& scene, const Isometry3d& pose)
{
  constexpr int min_pixels_of_surface = 5;
  constexpr double nearest_shape = 0.7; // along the camera's axis [m]
  const DepthCamera coarse_camera{48, 36};
  const DepthImage image = castDepthImage (scene, coarse_camera, pose);
  if (image.depth.minCoeff() < nearest_shape)
    return 0;
  std::map<SurfaceId, int> pixels;
  for (const SurfaceId surface : image.surface)
    ++pixels[surface];
  int visible = 0;
  for (const auto& [surface, count] : pixels)
    visible += surface != no_surface && count >= min_pixels_of_surface;
  return visible;
}

Isometry3d
drawCameraPose (const Site& room, Seed seed)
{
  Random random = randomFor (Purpose::CameraPose, seed);
  const auto drawPose = [&] () -> CameraPath {
    constexpr double wall_distance = 0.4; // [m]
    // Positions are drawn with x and y from -1 to 1, which reach is to multiply; their
    // z is a height [m] and stays.
    Vector3d reach = 0.5 * room.size - Vector3d::Constant (wall_distance);
    reach.z() = 1.0;
    // From anywhere, the camera looks at a position around the middle of the room,
    // somewhat downwards.
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
  constexpr PathSearch search{32, 1}; // each path is a single pose
  return drawBestPath (room, search, drawPose) (0.0);
}

Poses
drawWalk (const Site& room, std::size_t frames, Seed seed)
{
  Random random = randomFor (Purpose::Walk, seed);
  const auto drawPath = [&] { return drawPathAround (room, random); };
  constexpr PathSearch search{8, 12};
  return posesOn (drawBestPath (room, search, drawPath), frames);
}

} // namespace pcl_ops::simulation
