// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scenes.h"

#include <algorithm>

namespace pcl_ops::simulation {

namespace {

using Kind = Shape::Kind;

/** Ranges of sizes [m]; heights of domes follow from their radii. large_height of a
 * cone is a multiple of its radius, of a torus one of the smallest large radius. */
constexpr struct ShapeSizes {
  Kind kind;
  struct {
    double lower, upper;
  } small_radius, small_height, large_height;
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
  const Vector3d none = Vector3d::Zero();
  return {kind, center, up, none, height, radius, no_surface, share};
}

/** Draws a small shape beside the ground, which begins at y = 0.
 * \param[in] position in the row, from 0 to 3 */
Shape
drawSmall (const ShapeSizes& sizes, int position, Random& random)
{
  constexpr double distance = 1.8;
  constexpr double row = -1.2; // room for the two largest [m]
  const auto& [lowest_radius, highest_radius] = sizes.small_radius;
  const auto& [lowest, highest] = sizes.small_height;
  const double radius = random.between (lowest_radius, highest_radius);
  const bool is_sphere = sizes.kind == Kind::Dome;
  const double height = is_sphere ? 2.0 * radius : random.between (lowest, highest);
  const double z = is_sphere ? radius : height;
  return makeRound (sizes.kind, {(position - 1.5) * distance, row, z}, radius, height);
}

/** Draws a part of a large shape, in a row behind the small shapes. */
Shape
drawLarge (const ShapeSizes& sizes, int position, Random& random)
{
  constexpr double distance = 3.0;
  constexpr double row = -3.8; // [m]
  constexpr double smallest = 0.6;
  constexpr double largest = 5.5; // radii [m]
  const double x = (position - 1.5) * distance;
  // The logarithm is uniform.
  const double radius = smallest * std::pow (largest / smallest, random.unit());
  const double unit = sizes.kind == Kind::Cone    ? radius
                      : sizes.kind == Kind::Torus ? smallest
                                                  : 1.0;
  const bool is_dome = sizes.kind == Kind::Dome;
  const auto& [lowest, highest] = sizes.large_height;
  double height = is_dome ? 0.0 : unit * random.between (lowest, highest);
  // The part is 2 to 2.4 m long, so that it bends by far more than the noise at any
  // radius; for small radii it is about a third of a turn.
  const double length = std::min (random.between (2.0, 2.4), 2.0 * radius);
  const double share = length / (2.0 * pi * radius);
  if (!is_dome)
    return makeRound (sizes.kind, {x, row - radius, height}, radius, height, share);
  height = radius * (1.0 - std::cos (pi * share));
  return makeRound (sizes.kind, {x, row, height - radius}, radius, height);
}

/** Draws a board on the middle of the ground, with any yaw, leaning back a little. */
Shape
drawBoard (const Shape& ground, Random& random)
{
  const double turned = random.angle (0, 360);
  const double tilt = random.angle (70, 90);
  const Isometry3d pose = turnZ (turned) * turnX (tilt);
  Shape board;
  board.half_u = 0.5 * random.between (0.8, 1.6);
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
  for (int i = 0; i < 4; ++i)
    shapes.push_back (drawSmall (sizes_of_shapes[i], i, random));
  Shape ground = makeRectangle ({0, 2, 0}, {6, 0, 0}, {0, 4, 0});
  Shape board = drawBoard (ground, random);
  for (int i = 0; i < 4; ++i)
    shapes.push_back (drawLarge (sizes_of_shapes[i], i, random));
  ground.surface = 1;
  board.surface = 2;
  shapes.insert (shapes.end(), {ground, board});
  Random scan = randomFor (Purpose::ShapesScan, seed);
  return labeledBySize (drawPoints (shapes, points, noise * shapes_sigma, scan),
                        {ground.plane(), board.plane()});
}

} // namespace pcl_ops::simulation
