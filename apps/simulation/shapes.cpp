// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "shapes.h"

#include <algorithm>

namespace pcl_ops::simulation {

namespace {

using Round = RoundShape::Kind;

/** \brief From which the sizes of a small shape and of a large one are drawn [m];
 * heights of domes follow from their radii. The large height of a cone is in multiples
 * of its radius, that of a torus of the smallest large radius. */
constexpr struct ShapeSizes {
  Round kind;
  struct {
    double lower, upper;
  } small_radius, small_height, large_height;
} sizes_of_shapes[] = {{Round::Dome, {0.3, 0.6}, {0.0, 0.0}, {0.0, 0.0}},
                       {Round::Cylinder, {0.15, 0.4}, {0.5, 1.0}, {0.5, 0.8}},
                       {Round::Cone, {0.3, 0.6}, {0.8, 1.6}, {0.7, 1.0}},
                       {Round::Torus, {0.4, 0.6}, {0.1, 0.2}, {0.3, 0.5}}};

SurfacePoint
drawOfWhole (const RoundShape& shape, Random& random)
{
  const double radius = shape.radius, height = shape.height;
  const Vector3d &center = shape.center, up = Vector3d::UnitZ();
  if (shape.kind == Round::Dome)
    return drawAbove (1.0 - height / radius, center, radius, random);
  if (shape.kind == Round::Cylinder)
    return drawPoint (
        Shape{Shape::Kind::Cylinder, center, up, Vector3d::Zero(), height, radius},
        random);
  const Vector3d across = drawAcross (random);
  if (shape.kind == Round::Cone) {
    // The share of area above grows with the square of the distance from the apex.
    const double down = std::sqrt (random.unit());
    return {center + down * (radius * across - height * up),
            (height * across + radius * up).normalized()};
  }
  double around_tube = 0.0;
  do // the outer side of the ring is longer than the inner one
    around_tube = random.between (0, 2.0 * pi);
  while (
      !random.chance ((radius + height * std::cos (around_tube)) / (radius + height)));
  const Vector3d normal = std::cos (around_tube) * across + std::sin (around_tube) * up;
  return {center + radius * across + height * normal, normal};
}

/** \brief Beside the ground, which begins at y = 0.
 * \param[in] position in the row, from 0 to 3 */
RoundShape
drawSmall (const ShapeSizes& sizes, int position, Random& random)
{
  constexpr double distance = 1.8, row = -1.2; // room for the two largest [m]
  const auto& [lowest_radius, highest_radius] = sizes.small_radius;
  const auto& [lowest, highest] = sizes.small_height;
  const double radius = random.between (lowest_radius, highest_radius);
  const bool is_sphere = sizes.kind == Round::Dome;
  const double height = is_sphere ? 2.0 * radius : random.between (lowest, highest);
  const double z = is_sphere ? radius : height;
  return {sizes.kind, {(position - 1.5) * distance, row, z}, radius, height};
}

/** \brief Behind the small ones. */
RoundShape
drawLarge (const ShapeSizes& sizes, int position, Random& random)
{
  constexpr double distance = 3.0, row = -3.8;    // [m]
  constexpr double smallest = 0.6, largest = 5.5; // radii [m]
  const double x = (position - 1.5) * distance;
  // Of equal chance for each octave.
  const double radius = smallest * std::pow (largest / smallest, random.unit());
  const double unit = sizes.kind == Round::Cone    ? radius
                      : sizes.kind == Round::Torus ? smallest
                                                   : 1.0;
  const bool is_dome = sizes.kind == Round::Dome;
  const auto& [lowest, highest] = sizes.large_height;
  double height = is_dome ? 0.0 : unit * random.between (lowest, highest);
  // 2 to 2.4 m long, so that it bends by far more than the noise however large the
  // radius; of small ones about a third of a turn.
  const double length = std::min (random.between (2.0, 2.4), 2.0 * radius);
  const double share = length / (2.0 * pi * radius);
  if (!is_dome)
    return {sizes.kind, {x, row - radius, height}, radius, height, share};
  height = radius * (1.0 - std::cos (pi * share));
  return {sizes.kind, {x, row, height - radius}, radius, height};
}

/** \brief A board on the middle of the ground, turned about the vertical and leaning
 * back a little. */
Shape
drawBoard (const Shape& ground, Random& random)
{
  const double turned = random.angle (0, 360), tilt = random.angle (70, 90);
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

SurfacePoint
drawPoint (const RoundShape& shape, Random& random)
{
  const SurfacePoint whole = drawOfWhole (shape, random);
  if (!(shape.share < 1.0))
    return whole;
  // Turned about the axis into the part.
  const Vector3d local = whole.position - shape.center;
  const double around = std::atan2 (-local.x(), local.y());
  const Eigen::AngleAxisd turn ((shape.share - 1.0) * around, Vector3d::UnitZ());
  return {shape.center + turn * local, turn * whole.normal};
}

SimulatedCloud
simulateShapes (std::size_t points, double noise, Seed seed)
{
  Random random = randomFor (Purpose::Shapes, seed);
  std::vector<ScannedSurface> surfaces;
  const auto add = [&surfaces] (const auto& shape, SurfaceId surface) {
    surfaces.push_back ({shape.area(), surface, [shape] (Random& random) {
                           return drawPoint (shape, random);
                         }});
  };
  for (int i = 0; i < 4; ++i)
    add (drawSmall (sizes_of_shapes[i], i, random), no_surface);
  const Shape ground = makeRectangle ({0, 2, 0}, {6, 0, 0}, {0, 4, 0});
  const Shape board = drawBoard (ground, random);
  for (int i = 0; i < 4; ++i)
    add (drawLarge (sizes_of_shapes[i], i, random), no_surface);
  add (ground, 1);
  add (board, 2);
  Random scan = randomFor (Purpose::ShapesScan, seed);
  return labeledBySize (drawPoints (surfaces, points, noise * shapes_sigma, scan),
                        {ground.plane(), board.plane()});
}

} // namespace pcl_ops::simulation
