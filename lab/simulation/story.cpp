// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "story.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <tuple>

namespace pcl_ops::simulation {

namespace {

using Eigen::AlignedBox2d;

// All lengths and heights are in meters. They are those of common rooms, chosen by
// hand.

constexpr double ceiling_height = 2.6;
constexpr std::size_t rays_per_position = 100'000;

struct Interval {
  double from, to;
};

/** A rectangle of a wall without a surface: its range along the wall and its heights.
 */
struct Hole {
  double from, to, bottom, top;
};

/** The wall face on one side of a room, at right angles to an axis. */
struct Face {
  std::size_t room;
  int axis;          // 0: x, 1: y
  double coordinate; // of the face on the axis
  double front;      // 1: the room is at larger coordinates than the face, -1: smaller
  double from, to;   // range of the face on the other horizontal axis
  std::vector<Hole> holes = {};

  /** Returns a position at the face, in the frame of the rooms.
   * \param[in] along coordinate on the other horizontal axis
   * \param[in] into_room distance from the face; negative inside the wall */
  Vector3d
  position (double along, double into_room, double height) const
  {
    Vector3d result (along, along, height);
    result[axis] = coordinate + front * into_room;
    return result;
  }

  /** Whether there is no hole in a range of the face or within 0.1 m of it. */
  bool
  isWhole (const Interval& range) const
  {
    constexpr double clearance = 0.1;
    return std::none_of (holes.begin(), holes.end(), [&] (const Hole& hole) {
      return hole.from < range.to + clearance && hole.to > range.from - clearance;
    });
  }
};

/** Divides a box by a wall in two parts, and these in the same way, until all parts are
 * as small as rooms. Appends these parts to \p rooms. */
void
divide (const AlignedBox2d& box, Random& random, std::vector<AlignedBox2d>& rooms)
{
  constexpr double largest_area = 24.0; // [m^2]
  constexpr double thicknesses[] = {0.08, 0.1, 0.12, 0.15, 0.24};
  const Vector2d sizes = box.sizes();
  const double area_limit = largest_area * random.between (0.6, 1.0);
  if (box.volume() < area_limit) { // the volume of a 2-d box is its area
    rooms.push_back (box);
    return;
  }
  const int axis = sizes.x() > sizes.y() ? 0 : 1;
  const std::uint32_t drawn = random.below (std::uint32_t (std::size (thicknesses)));
  const double half_wall = 0.5 * thicknesses[drawn];
  const double middle = box.min()[axis] + random.between (0.38, 0.62) * sizes[axis];
  Vector2d end_of_first = box.max();
  Vector2d begin_of_second = box.min();
  end_of_first[axis] = middle - half_wall;
  begin_of_second[axis] = middle + half_wall;
  divide ({box.min(), end_of_first}, random, rooms);
  divide ({begin_of_second, box.max()}, random, rooms);
}

std::vector<Face>
facesOf (const std::vector<AlignedBox2d>& rooms)
{
  std::vector<Face> faces;
  for (std::size_t i = 0; i < rooms.size(); ++i)
    for (const int axis : {0, 1}) {
      const double from = rooms[i].min()[1 - axis];
      const double to = rooms[i].max()[1 - axis];
      faces.push_back ({i, axis, rooms[i].min()[axis], 1.0, from, to});
      faces.push_back ({i, axis, rooms[i].max()[axis], -1.0, from, to});
    }
  return faces;
}

/** \return whether two faces are back to back, as the two sides of one wall; their
 * ranges along the wall need not overlap */
bool
areSidesOfAWall (const Face& one, const Face& other)
{
  constexpr double thickest = 0.25;
  const double thickness = one.front * (one.coordinate - other.coordinate);
  return one.axis == other.axis && one.front == -other.front && thickness > 0.0 &&
         thickness < thickest;
}

/** Adds the four surfaces around an opening, from a face into the wall.
 * \param[in] depth of these surfaces */
void
addReveal (const Face& face, const Hole& hole, double depth, Body& body)
{
  const Vector3d across = face.position (0, -depth, 0) - face.position (0, 0, 0);
  const auto add = [&] (const Vector3d& from, const Vector3d& to) {
    body.shapes.push_back (
        makeRectangle (0.5 * (from + to + across), to - from, across));
  };
  const Vector3d low_left = face.position (hole.from, 0, hole.bottom);
  const Vector3d low_right = face.position (hole.to, 0, hole.bottom);
  const Vector3d high_left = face.position (hole.from, 0, hole.top);
  const Vector3d high_right = face.position (hole.to, 0, hole.top);
  add (low_left, low_right);
  add (high_left, high_right);
  add (low_left, high_left);
  add (low_right, high_right);
}

/** A door, or a glass pane. */
struct Passage {
  Hole hole;
  bool is_pane;
};

/** Draws a door or, if the wall may have glass and is long enough, a pane.
 * \param[in] wall the range that the faces of both rooms have in common */
Passage
drawPassage (const Interval& wall, bool has_glass, Random& random)
{
  constexpr double door_width = 0.9;
  constexpr double door_height = 2.05;
  constexpr double beside_door = 0.2; // least wall on each side
  constexpr double beside_pane = 0.3;
  const double door =
      random.between (wall.from + beside_door, wall.to - door_width - beside_door);
  // Drawn also without glass, so that a story with glass is the same up to its first
  // pane, for which one more number is drawn.
  const double pane_width = random.between (1.5, 2.5);
  const bool is_pane = has_glass && wall.to - wall.from > pane_width + 1.0;
  if (!is_pane)
    return {{door, door + door_width, 0.0, door_height}, is_pane};
  const double pane =
      random.between (wall.from + beside_pane, wall.to - pane_width - beside_pane);
  return {{pane, pane + pane_width, 0.0, ceiling_height - 0.1}, is_pane};
}

/** Cuts a door or a pane into each wall between two rooms that is long enough. */
void
cutDoorsAndPanes (const StoryHardship& hardship,
                  Random& random,
                  std::vector<Face>& faces,
                  Story& story,
                  Body& body)
{
  constexpr double shortest_wall = 1.4; // with a door
  for (std::size_t i = 0; i < faces.size(); ++i)
    for (std::size_t j = i + 1; j < faces.size(); ++j) {
      Face& one = faces[i];
      Face& other = faces[j];
      const Interval wall{std::max (one.from, other.from), std::min (one.to, other.to)};
      if (!areSidesOfAWall (one, other) || wall.to - wall.from < shortest_wall)
        continue;
      const double thickness = std::abs (one.coordinate - other.coordinate);
      const Passage passage = drawPassage (wall, hardship.has_glass, random);
      for (Face* const face : {&one, &other})
        face->holes.push_back (passage.hole);
      story.doors.emplace (one.room, other.room);
      if (!passage.is_pane) // a pane is as thick as the wall
        addReveal (one, passage.hole, thickness, body);
    }
}

/** Cuts a window into each outer wall that is long enough. */
void
cutWindows (Random& random, std::vector<Face>& faces, Body& body)
{
  constexpr double width = 1.2;
  constexpr double sill = 0.9;
  constexpr double top = 2.1;
  constexpr double depth = 0.2;
  constexpr double beside = 0.4; // least wall on each side
  std::vector<Face*> outer;
  for (Face& face : faces)
    if (std::none_of (faces.begin(), faces.end(), [&] (const Face& other) {
          return areSidesOfAWall (face, other);
        }))
      outer.push_back (&face);
  for (Face* const face : outer)
    if (face->to - face->from > width + 1.0) {
      const double begin =
          random.between (face->from + beside, face->to - width - beside);
      const Hole hole{begin, begin + width, sill, top};
      face->holes.push_back (hole);
      addReveal (*face, hole, depth, body);
    }
}

/** Returns the heights of the holes at a position along a wall, lowest first, and at
 * the end of the list the height of the ceiling as an empty interval. */
std::vector<Interval>
openHeightsAt (double along, const std::vector<Hole>& holes)
{
  std::vector<Interval> open;
  for (const Hole& hole : holes)
    if (hole.from < along && along < hole.to)
      open.push_back ({hole.bottom, hole.top});
  std::sort (open.begin(), open.end(), [] (const Interval& one, const Interval& other) {
    return std::tie (one.from, one.to) < std::tie (other.from, other.to);
  });
  open.push_back ({ceiling_height, ceiling_height});
  return open;
}

/** Adds a face without its holes. The upright edges of all holes divide it into strips;
 * each strip has rectangles below, between and above the holes.
 * \param[in] missing one more hole: the part without readings */
void
addFace (const Face& face, const Hole& missing, Body& body)
{
  constexpr double narrowest = 1e-6;
  std::vector<Hole> holes = face.holes;
  holes.push_back (missing);
  std::vector<double> cuts = {face.from, face.to};
  for (const Hole& hole : holes) {
    cuts.push_back (hole.from);
    cuts.push_back (hole.to);
  }
  std::sort (cuts.begin(), cuts.end());
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    const double middle = 0.5 * (cuts[i] + cuts[i + 1]);
    if (cuts[i + 1] - cuts[i] < narrowest)
      continue;
    const Vector3d width =
        face.position (cuts[i + 1], 0, 0) - face.position (cuts[i], 0, 0);
    double bottom = 0.0;
    for (const Interval& open : openHeightsAt (middle, holes)) {
      if (open.from > bottom)
        body.shapes.push_back (
            makeRectangle (face.position (middle, 0, 0.5 * (bottom + open.from)),
                           width,
                           (open.from - bottom) * Vector3d::UnitZ()));
      bottom = std::max (bottom, open.to);
    }
  }
}

/** Adds the floors and ceilings. */
void
addLevels (const std::vector<AlignedBox2d>& rooms,
           const std::vector<Face>& faces,
           bool has_ceiling,
           Body& body)
{
  const auto add = [&] (const Vector2d& low, const Vector2d& high, double height) {
    const Vector2d middle = 0.5 * (low + high);
    body.shapes.push_back (makeRectangle ({middle.x(), middle.y(), height},
                                          (high.x() - low.x()) * Vector3d::UnitX(),
                                          (high.y() - low.y()) * Vector3d::UnitY()));
  };
  for (const AlignedBox2d& room : rooms) {
    add (room.min(), room.max(), 0.0);
    if (has_ceiling)
      add (room.min(), room.max(), ceiling_height);
  }
  // Floors continue through doors and panes, from each side by half the thickness of
  // the thickest wall. In thinner walls the strips of both sides overlap.
  constexpr double into_wall = 0.12;
  for (const Face& face : faces)
    for (const Hole& hole : face.holes)
      if (hole.bottom == 0.0) {
        const Vector3d one = face.position (hole.from, 0, 0);
        const Vector3d other = face.position (hole.to, -into_wall, 0);
        add (one.head<2>().cwiseMin (other.head<2>()),
             one.head<2>().cwiseMax (other.head<2>()),
             0.0);
      }
}

/** Adds cupboards in front of a wall, but not of its openings, until they hide a share
 * of its length to within 0.3 m. Ends after 20 attempts to place one. */
void
furnish (const Face& face, double share, Random& random, Body& body)
{
  constexpr int attempts = 20;
  constexpr double from_corner = 0.6; // cupboards of two walls do not meet
  constexpr double narrowest = 0.3;
  constexpr double from_wall = 0.01;
  const double first = face.from + from_corner;
  const double last = face.to - from_corner;
  double length_to_hide = share * (face.to - face.from);
  std::vector<Interval> taken;
  for (int i = 0; i < attempts && length_to_hide > narrowest; ++i) {
    const double width = std::min (length_to_hide, random.between (0.6, 1.6));
    const double begin = random.between (first, std::max (first, last - width));
    const Interval cupboard{begin, begin + width};
    const bool is_taken =
        std::any_of (taken.begin(), taken.end(), [&] (const Interval& other) {
          return other.from < cupboard.to && other.to > cupboard.from;
        });
    if (is_taken || !face.isWhole (cupboard) || cupboard.to > last)
      continue;
    const double depth = random.between (0.3, 0.55);
    const double height = random.between (0.7, 2.0);
    Vector3d size (width, width, height);
    size[face.axis] = depth;
    const double middle = 0.5 * (cupboard.from + cupboard.to);
    body.addBox (at (face.position (middle, 0.5 * depth + from_wall, 0.5 * height)),
                 size,
                 HiddenFace::Bottom);
    taken.push_back (cupboard);
    length_to_hide -= width;
  }
}

/** Adds boxes and balls on the floor of a room. */
void
scatterClutter (const AlignedBox2d& room, int pieces, Random& random, Body& body)
{
  for (int i = 0; i < pieces; ++i) {
    constexpr double from_walls = 0.8;
    const double size = random.between (0.2, 0.6);
    const Vector2d low = room.min().array() + from_walls;
    const Vector2d sizes = room.sizes().array() - 2.0 * from_walls;
    const Vector3d center{low.x() + sizes.x() * random.unit(),
                          low.y() + sizes.y() * random.unit(),
                          0.5 * size};
    if (random.below (2) == 0)
      body.addSphere (center, 0.5 * size);
    else
      body.addBox (at (center) * turnZ (random.angle (0.0, 90.0)),
                   Vector3d::Constant (size),
                   HiddenFace::Bottom);
  }
}

/** Returns the direction of a ray, a unit vector. The rays of a position are evenly
 * spread on a spiral: each is turned from the one before by the golden angle.
 * \param[in] ray from 0 to rays_per_position - 1 */
Vector3d
directionOf (std::size_t ray)
{
  const double z = 1.0 - (2.0 * static_cast<double> (ray) + 1.0) / rays_per_position;
  const double angle = static_cast<double> (ray) * pi * (3.0 - std::sqrt (5.0));
  const double radius = std::sqrt (1.0 - z * z);
  return {radius * std::cos (angle), radius * std::sin (angle), z};
}

/** Scans each room from a position near its middle, and appends the points to the cloud
 * of the story. On the way from room to room an error in a random direction is added to
 * the position, by the drift. */
void
scanRooms (const Scene& scene,
           const StoryHardship& hardship,
           Random& random,
           Story& story)
{
  const ShapeTree tree = treeOf (scene);
  const Isometry3d turn = turnZ (story.yaw);
  constexpr double tripod_height = 1.6;
  Vector3d position_error = Vector3d::Zero();
  std::optional<Vector3d> previous;
  for (const AlignedBox2d& room : story.rooms) {
    const Vector2d middle = room.center();
    const Vector3d position{middle.x() + random.between (-0.2, 0.2),
                            middle.y() + random.between (-0.2, 0.2),
                            tripod_height};
    if (previous) {
      const double angle = random.angle (0.0, 360.0);
      position_error += hardship.drift * (position - *previous).norm() *
                        Vector3d (std::cos (angle), std::sin (angle), 0.0);
    }
    previous = position;
    for (std::size_t i = 0; i < rays_per_position; ++i) {
      const Vector3d direction = directionOf (i);
      const Hit hit = castRay (tree, position, direction);
      if (!std::isfinite (hit.distance))
        continue;
      const Vector3d noise{random.gaussian(), random.gaussian(), random.gaussian()};
      const Vector3d point = position + hit.distance * direction + position_error;
      story.cloud.push_back (pointAt (turn * point + hardship.noise * noise, 0));
    }
  }
}

} // namespace

Story
makeStory (Seed seed, const StoryHardship& hardship)
{
  Random random = randomFor (Purpose::Story, seed);
  Story story;
  // Braces fix the order of evaluation; parentheses do not.
  const Vector2d size{random.between (10.0, 13.0), random.between (7.0, 9.0)};
  divide ({-0.5 * size, 0.5 * size}, random, story.rooms);
  story.yaw = random.angle (0.0, 45.0);
  Body body;
  std::vector<Face> faces = facesOf (story.rooms);
  cutDoorsAndPanes (hardship, random, faces, story, body);
  cutWindows (random, faces, body);
  for (const Face& face : faces) {
    const double length = hardship.missing * (face.to - face.from);
    const double begin = random.between (face.from, face.to - length);
    addFace (face, {begin, begin + length, 0.0, ceiling_height}, body);
    furnish (face, hardship.furnished, random, body);
  }
  addLevels (story.rooms, faces, hardship.has_ceiling, body);
  for (const AlignedBox2d& room : story.rooms)
    scatterClutter (room, hardship.clutter, random, body);
  Scene scene;
  scene.add (body, Isometry3d::Identity());
  scanRooms (scene, hardship, random, story);
  return story;
}

} // namespace pcl_ops::simulation
