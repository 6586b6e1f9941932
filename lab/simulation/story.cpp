// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "story.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace pcl_ops::simulation {

namespace {

using Eigen::AlignedBox2d;

constexpr double ceiling_height = 2.6;
constexpr std::size_t rays_of_position = 100'000;

/** A rectangle of a wall without a surface: its range along the wall and its heights
 * [m]. */
struct Hole {
  double from, to, bottom, top;
};

/** The wall face on one side of a room. */
struct Face {
  std::size_t room;
  /** The face is at the coordinate \p place of this axis (0: x, 1: y); its front looks
   * along the axis (1) or against it (-1). */
  int axis;
  double place, front;
  double from, to; // along the other axis
  std::vector<Hole> holes = {};

  Vector3d
  at (double along, double off, double height) const
  {
    Vector3d place_of_it (along, along, height);
    place_of_it[axis] = place + front * off;
    return place_of_it;
  }

  bool
  isFree (double begin, double end) const
  {
    constexpr double beside = 0.1;
    return std::none_of (holes.begin(), holes.end(), [&] (const Hole& hole) {
      return hole.from < end + beside && hole.to > begin - beside;
    });
  }
};

/** Divides a box by walls in two parts, until all parts are as small as rooms. */
void
divide (const AlignedBox2d& box, Random& random, std::vector<AlignedBox2d>& rooms)
{
  constexpr double largest_room = 24.0;
  constexpr double thicknesses[] = {0.08, 0.1, 0.12, 0.15, 0.24};
  const Vector2d sizes = box.sizes();
  const double wanted = largest_room * random.between (0.6, 1.0);
  if (box.volume() < wanted) {
    rooms.push_back (box);
    return;
  }
  const int axis = sizes.x() > sizes.y() ? 0 : 1;
  const double half = 0.5 * thicknesses[random.below (5)];
  const double at = box.min()[axis] + random.between (0.38, 0.62) * sizes[axis];
  Vector2d high = box.max();
  Vector2d low = box.min();
  high[axis] = at - half;
  low[axis] = at + half;
  divide ({box.min(), high}, random, rooms);
  divide ({low, box.max()}, random, rooms);
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

/** \return whether two faces are back to back, as the two sides of one wall */
bool
areSidesOfAWall (const Face& one, const Face& other)
{
  constexpr double thickest = 0.25;
  const double apart = one.front * (one.place - other.place);
  return one.axis == other.axis && one.front == -other.front && apart > 0.0 &&
         apart < thickest;
}

/** Adds the four surfaces around an opening, through the whole wall. */
void
addReveal (const Face& face, const Hole& hole, double depth, Body& body)
{
  const Vector3d across = face.at (0, -depth, 0) - face.at (0, 0, 0);
  const auto add = [&] (const Vector3d& from, const Vector3d& to) {
    body.shapes.push_back (
        makeRectangle (0.5 * (from + to + across), to - from, across));
  };
  const Vector3d low_left = face.at (hole.from, 0, hole.bottom);
  const Vector3d low_right = face.at (hole.to, 0, hole.bottom);
  const Vector3d high_left = face.at (hole.from, 0, hole.top);
  const Vector3d high_right = face.at (hole.to, 0, hole.top);
  add (low_left, low_right);
  add (high_left, high_right);
  add (low_left, high_left);
  add (low_right, high_right);
}

void
cutDoorsAndPanes (const StoryHardship& hardship,
                  Random& random,
                  std::vector<Face>& faces,
                  Story& story,
                  Body& body)
{
  constexpr double door_width = 0.9;
  constexpr double door_height = 2.05;
  constexpr double least = 1.4; // length of a wall with a door [m]
  for (std::size_t i = 0; i < faces.size(); ++i)
    for (std::size_t j = i + 1; j < faces.size(); ++j) {
      Face& one = faces[i];
      Face& other = faces[j];
      const double from = std::max (one.from, other.from);
      const double to = std::min (one.to, other.to);
      if (!areSidesOfAWall (one, other) || to - from < least)
        continue;
      const double depth = std::abs (one.place - other.place);
      const double begin = random.between (from + 0.2, to - door_width - 0.2);
      Hole hole{begin, begin + door_width, 0.0, door_height};
      const double pane = random.between (1.5, 2.5);
      const bool is_pane = hardship.has_glass && to - from > pane + 1.0;
      if (is_pane) {
        const double start = random.between (from + 0.3, to - pane - 0.3);
        hole = {start, start + pane, 0.0, ceiling_height - 0.1};
      }
      for (Face* const face : {&one, &other})
        face->holes.push_back (hole);
      story.doors.emplace (one.room, other.room);
      if (!is_pane)
        addReveal (one, hole, depth, body);
    }
}

void
cutWindows (Random& random, std::vector<Face>& faces, Body& body)
{
  constexpr double width = 1.2;
  constexpr double sill = 0.9;
  constexpr double head = 2.1;
  constexpr double depth = 0.2;
  std::vector<Face*> outer;
  for (Face& face : faces)
    if (std::none_of (faces.begin(), faces.end(), [&] (const Face& other) {
          return areSidesOfAWall (face, other);
        }))
      outer.push_back (&face);
  for (Face* const face : outer)
    if (face->to - face->from > width + 1.0) {
      const double begin = random.between (face->from + 0.4, face->to - width - 0.4);
      const Hole hole{begin, begin + width, sill, head};
      face->holes.push_back (hole);
      addReveal (*face, hole, depth, body);
    }
}

/** Adds a face without its holes and without the part that gives no reading. */
void
addFace (const Face& face, const Hole& unread, Body& body)
{
  std::vector<Hole> holes = face.holes;
  holes.push_back (unread);
  std::vector<double> cuts = {face.from, face.to};
  for (const Hole& hole : holes) {
    cuts.push_back (hole.from);
    cuts.push_back (hole.to);
  }
  std::sort (cuts.begin(), cuts.end());
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    const double middle = 0.5 * (cuts[i] + cuts[i + 1]);
    if (cuts[i + 1] - cuts[i] < 1e-6)
      continue;
    std::vector<std::pair<double, double>> open;
    for (const Hole& hole : holes)
      if (hole.from < middle && middle < hole.to)
        open.emplace_back (hole.bottom, hole.top);
    std::sort (open.begin(), open.end());
    open.emplace_back (ceiling_height, ceiling_height);
    double bottom = 0.0;
    for (const auto& [from, to] : open) {
      if (from > bottom)
        body.shapes.push_back (
            makeRectangle (face.at (middle, 0, 0.5 * (bottom + from)),
                           face.at (cuts[i + 1], 0, 0) - face.at (cuts[i], 0, 0),
                           (from - bottom) * Vector3d::UnitZ()));
      bottom = std::max (bottom, to);
    }
  }
}

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
  // Floors go on through doors.
  constexpr double behind_wall = 0.12;
  for (const Face& face : faces)
    for (const Hole& hole : face.holes)
      if (hole.bottom == 0.0) {
        const Vector3d one = face.at (hole.from, 0, 0);
        const Vector3d other = face.at (hole.to, -behind_wall, 0);
        add (one.head<2>().cwiseMin (other.head<2>()),
             one.head<2>().cwiseMax (other.head<2>()),
             0.0);
      }
}

/** Adds cupboards in front of a wall, but not of its openings, until they hide a share
 * of its length. */
void
furnish (const Face& face, double share, Random& random, Body& body)
{
  constexpr int tries = 20;
  constexpr double corner = 0.6;
  double left = share * (face.to - face.from);
  std::vector<std::pair<double, double>> taken;
  for (int i = 0; i < tries && left > 0.3; ++i) {
    const double width = std::min (left, random.between (0.6, 1.6));
    const double begin = random.between (
        face.from + corner, std::max (face.from + corner, face.to - corner - width));
    const double end = begin + width;
    const bool is_taken =
        std::any_of (taken.begin(), taken.end(), [&] (const auto& one) {
          return one.first < end && one.second > begin;
        });
    if (is_taken || !face.isFree (begin, end) || end > face.to - corner)
      continue;
    const double depth = random.between (0.3, 0.55);
    const double height = random.between (0.7, 2.0);
    Vector3d size (width, width, height);
    size[face.axis] = depth;
    body.addBox (at (face.at (0.5 * (begin + end), 0.5 * depth + 0.01, 0.5 * height)),
                 size,
                 HiddenFace::Bottom);
    taken.emplace_back (begin, end);
    left -= width;
  }
}

void
scatterClutter (const AlignedBox2d& room, int pieces, Random& random, Body& body)
{
  for (int i = 0; i < pieces; ++i) {
    const double size = random.between (0.2, 0.6);
    const Vector2d low = room.min().array() + 0.8;
    const Vector2d sizes = room.sizes().array() - 1.6;
    const Vector3d place{low.x() + sizes.x() * random.unit(),
                         low.y() + sizes.y() * random.unit(),
                         0.5 * size};
    if (random.below (2) == 0)
      body.addSphere (place, 0.5 * size);
    else
      body.addBox (at (place) * turnZ (random.angle (0.0, 90.0)),
                   Vector3d::Constant (size),
                   HiddenFace::Bottom);
  }
}

/** Returns the i-th of evenly spread unit directions (golden angle spiral). */
Vector3d
directionOf (std::size_t i)
{
  const double z = 1.0 - (2.0 * static_cast<double> (i) + 1.0) / rays_of_position;
  const double angle = static_cast<double> (i) * pi * (3.0 - std::sqrt (5.0));
  const double radius = std::sqrt (1.0 - z * z);
  return {radius * std::cos (angle), radius * std::sin (angle), z};
}

void
scanRooms (const Scene& scene,
           const StoryHardship& hardship,
           Random& random,
           Story& story)
{
  const ShapeTree tree = treeOf (scene);
  const Isometry3d turn = turnZ (story.yaw);
  Vector3d error = Vector3d::Zero();
  std::optional<Vector3d> before;
  for (const AlignedBox2d& room : story.rooms) {
    const Vector2d middle = room.center();
    const Vector3d position{middle.x() + random.between (-0.2, 0.2),
                            middle.y() + random.between (-0.2, 0.2),
                            1.6};
    if (before) {
      const double angle = random.angle (0.0, 360.0);
      error += hardship.drift * (position - *before).norm() *
               Vector3d (std::cos (angle), std::sin (angle), 0.0);
    }
    before = position;
    for (std::size_t i = 0; i < rays_of_position; ++i) {
      const Vector3d direction = directionOf (i);
      const Hit hit = castRay (tree, position, direction);
      if (!std::isfinite (hit.distance))
        continue;
      const Vector3d noise{random.gaussian(), random.gaussian(), random.gaussian()};
      const Vector3d point = position + hit.distance * direction + error;
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
