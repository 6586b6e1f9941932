// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scenes.h"

#include <algorithm>

namespace pcl_ops::simulation {

namespace {

using Kind = Shape::Kind;

/** The sizes of the round shapes of a kind. The radius is Shape::half_v; the height is
 * Shape::half_u, which is half the length of a cylinder and the radius of a torus's
 * tube. Not used are heights of domes: a small dome is a whole sphere, and the height
 * of a large one follows from its length. Radii of large shapes are drawn by \ref
 * drawLarge. */
constexpr struct ShapeSizes {
  Kind kind;
  struct {
    double lower, upper;
  } small_radius, small_height, // of small shapes [m]
      large_height; // of large shapes; cylinder: [m], cone: in radii of the cone,
                    // torus: in smallest radii of large shapes
} sizes_of_shapes[] = {{Kind::Dome, {0.3, 0.6}, {0.0, 0.0}, {0.0, 0.0}},
                       {Kind::Cylinder, {0.15, 0.4}, {0.5, 1.0}, {0.5, 0.8}},
                       {Kind::Cone, {0.3, 0.6}, {0.8, 1.6}, {0.7, 1.0}},
                       {Kind::Torus, {0.4, 0.6}, {0.1, 0.2}, {0.3, 0.5}}};

/** Makes a shape about an upright axis. */
Shape
makeRound (
    Kind kind, const Vector3d& center, double radius, double height, double share = 1.0)
{
  const Vector3d up = Vector3d::UnitZ();
  const Vector3d unused = Vector3d::Zero();
  return {kind, center, up, unused, height, radius, no_surface, share};
}

/** Number of kinds of shapes; each row along x has one of each. */
constexpr int count_in_row = 4;

/** Returns x of a shape in a row whose middle is x = 0 [m].
 * \param[in] position in the row, from 0 to 3
 * \param[in] distance from shape to shape [m] */
double
xInRow (int position, double distance)
{
  return (position - 0.5 * (count_in_row - 1)) * distance;
}

/** Draws a small shape beside the ground, which begins at y = 0.
 * \param[in] position in the row, from 0 to 3 */
Shape
drawSmall (const ShapeSizes& sizes, int position, Random& random)
{
  // Distance from shape to shape, with room for two of the largest, and y of the row
  // [m].
  constexpr double distance = 1.8;
  constexpr double y_of_row = -1.2;
  const auto& [lowest_radius, highest_radius] = sizes.small_radius;
  const auto& [lowest, highest] = sizes.small_height;
  const double radius = random.between (lowest_radius, highest_radius);
  const bool is_sphere = sizes.kind == Kind::Dome; // as high as its sphere
  const double height = is_sphere ? 2.0 * radius : random.between (lowest, highest);
  const double z = is_sphere ? radius : height; // of the center; its foot is at 0
  return makeRound (
      sizes.kind, {xInRow (position, distance), y_of_row, z}, radius, height);
}

/** Draws a part of a large shape, in a row behind the small shapes.
 * \param[in] position in the row, from 0 to 3 */
Shape
drawLarge (const ShapeSizes& sizes, int position, Random& random)
{
  // Distance from shape to shape, and y of the row [m].
  constexpr double distance = 3.0;
  constexpr double y_of_row = -3.8;
  constexpr double smallest_radius = 0.6, largest_radius = 5.5; // [m]
  const double x = xInRow (position, distance);
  const double radius = drawLogUniform (smallest_radius, largest_radius, random);
  const double height_unit = sizes.kind == Kind::Cone    ? radius
                             : sizes.kind == Kind::Torus ? smallest_radius
                                                         : 1.0;
  const bool is_dome = sizes.kind == Kind::Dome;
  const auto& [lowest, highest] = sizes.large_height;
  const double height = is_dome ? 0.0 : height_unit * random.between (lowest, highest);
  // The part is 2 to 2.4 m long, but two radii at most, about a third of a turn. It
  // bends by far more than the noise at any radius.
  const double length = std::min (random.between (2.0, 2.4), 2.0 * radius);
  const double share = length / (2.0 * pi * radius);
  if (!is_dome)
    return makeRound (
        sizes.kind, {x, y_of_row - radius, height}, radius, height, share);
  const double height_of_dome = radius * (1.0 - std::cos (pi * share));
  return makeRound (
      sizes.kind, {x, y_of_row, height_of_dome - radius}, radius, height_of_dome);
}

/** Draws a board that stands on the middle of the ground, with any yaw, and leans back
 * by up to 20 degrees. */
Shape
drawBoard (const Shape& ground, Random& random)
{
  const double yaw = random.angle (0, 360);
  const double tilt = random.angle (70, 90);
  const Isometry3d pose = turnZ (yaw) * turnX (tilt);
  Shape board;
  board.half_u = 0.5 * random.between (0.8, 1.6); // [m]
  board.half_v = 0.5 * random.between (1.2, 2.0);
  board.u = pose.linear().col (0);
  board.v = pose.linear().col (1);
  board.center = ground.center + board.half_v * board.v;
  return board;
}

} // namespace

SimulatedCloud
simulateShapes (std::size_t points, double noise, Seed seed)
{
  Random random = randomFor (Purpose::Shapes, seed);
  Shapes shapes;
  for (int i = 0; i < count_in_row; ++i)
    shapes.push_back (drawSmall (sizes_of_shapes[i], i, random));
  Shape ground = makeRectangle ({0, 2, 0}, {6, 0, 0}, {0, 4, 0});
  Shape board = drawBoard (ground, random);
  for (int i = 0; i < count_in_row; ++i)
    shapes.push_back (drawLarge (sizes_of_shapes[i], i, random));
  ground.surface = 1;
  board.surface = 2;
  shapes.insert (shapes.end(), {ground, board});
  Random scan = randomFor (Purpose::ShapesScan, seed);
  return labeledBySize (drawPoints (shapes, points, noise * shapes_sigma, scan),
                        {ground.plane(), board.plane()});
}

} // namespace pcl_ops::simulation
