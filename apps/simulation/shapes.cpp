// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "shapes.h"

#include <algorithm>
#include <cmath>

namespace pcl_ops::simulation {

namespace {

using Eigen::Vector3d;
using Round = RoundShape::Kind;

/** \brief From which a size is drawn [m]. */
struct Range {
  double lower, upper;
};

/** \brief Sizes of a small shape and of a large one; heights of domes follow from
 * their radii. */
struct ShapeSizes {
  Round kind;
  Range small_radius, small_height, large_height;
  /** \brief The large height of a cone is in multiples of its radius, that of a torus
   * of the smallest large radius. */
};

constexpr ShapeSizes sizes_of_shapes[] = {
    {Round::Dome, {0.3, 0.6}, {0.0, 0.0}, {0.0, 0.0}},
    {Round::Cylinder, {0.15, 0.4}, {0.5, 1.0}, {0.5, 0.8}},
    {Round::Cone, {0.3, 0.6}, {0.8, 1.6}, {0.7, 1.0}},
    {Round::Torus, {0.4, 0.6}, {0.1, 0.2}, {0.3, 0.5}}};

double
draw (const Range& range, Random& random)
{
  return random.between (range.lower, range.upper);
}

// The share of area above grows with the square of the distance from the apex.
SurfacePoint
drawOfCone (const RoundShape& cone, Random& random)
{
  const Vector3d across = drawAcross (random);
  const double down = std::sqrt (random.unit());
  const Vector3d normal = cone.height * across + cone.radius * Vector3d::UnitZ();
  return {cone.center + down * (cone.radius * across - cone.height * Vector3d::UnitZ()),
          normal.normalized()};
}

// The outer side of the ring is longer than the inner one.
SurfacePoint
drawOfTorus (const RoundShape& torus, Random& random)
{
  const Vector3d across = drawAcross (random);
  for (;;) {
    const double around_tube = random.between (0, 2.0 * pi);
    const double outward = std::cos (around_tube);
    const double longest = torus.radius + torus.height;
    if (!random.chance ((torus.radius + torus.height * outward) / longest))
      continue;
    const Vector3d normal =
        outward * across + std::sin (around_tube) * Vector3d::UnitZ();
    return {torus.center + torus.radius * across + torus.height * normal, normal};
  }
}

SurfacePoint
drawOfWhole (const RoundShape& shape, Random& random)
{
  if (shape.kind == Round::Cone)
    return drawOfCone (shape, random);
  if (shape.kind == Round::Torus)
    return drawOfTorus (shape, random);
  if (shape.kind == Round::Dome)
    return drawAbove (
        1.0 - shape.height / shape.radius, shape.center, shape.radius, random);
  Body cylinder;
  addCylinder (cylinder, shape.center, Vector3d::UnitZ(), shape.height, shape.radius);
  return drawPoint (cylinder.shapes.front(), random);
}

/** \brief Beside the ground, which begins at y = 0.
 * \param[in] position in the row, from 0 to 3 */
RoundShape
drawSmall (const ShapeSizes& sizes, int position, Random& random)
{
  constexpr double distance = 1.8, row = -1.2; // room for the two largest [m]
  RoundShape shape;
  shape.kind = sizes.kind;
  shape.radius = draw (sizes.small_radius, random);
  const bool is_sphere = sizes.kind == Round::Dome;
  shape.height = is_sphere ? 2.0 * shape.radius : draw (sizes.small_height, random);
  shape.center = {
      (position - 1.5) * distance, row, is_sphere ? shape.radius : shape.height};
  return shape;
}

/** \brief Behind the small ones. */
RoundShape
drawLarge (const ShapeSizes& sizes, int position, Random& random)
{
  constexpr double distance = 3.0, row = -3.8;    // [m]
  constexpr double smallest = 0.6, largest = 5.5; // radii [m]
  RoundShape shape;
  shape.kind = sizes.kind;
  // Of equal chance for each octave.
  shape.radius = smallest * std::pow (largest / smallest, random.unit());
  const double unit = sizes.kind == Round::Cone    ? shape.radius
                      : sizes.kind == Round::Torus ? smallest
                                                   : 1.0;
  if (sizes.kind != Round::Dome)
    shape.height = unit * draw (sizes.large_height, random);
  // 2 to 2.4 m long, so that it bends by far more than the noise however large the
  // radius; of small ones about a third of a turn.
  const double length = std::min (random.between (2.0, 2.4), 2.0 * shape.radius);
  const double share = length / (2.0 * pi * shape.radius);
  const double x = (position - 1.5) * distance;
  if (sizes.kind == Round::Dome) {
    shape.height = shape.radius * (1.0 - std::cos (pi * share));
    shape.center = {x, row, shape.height - shape.radius};
  }
  else {
    shape.share = share;
    shape.center = {x, row - shape.radius, shape.height};
  }
  return shape;
}

/** \brief A board on the ground, turned about the vertical and leaning back a little.
 */
Shape
drawBoard (const Shape& ground, Random& random)
{
  const double turned = random.angle (0, 360), tilt = random.angle (70, 90);
  const Eigen::Isometry3d pose = turnZ (turned) * turnX (tilt);
  Shape board;
  board.half_u = 0.5 * random.between (0.8, 1.6);
  board.half_v = 0.5 * random.between (1.2, 2.0);
  board.u = pose.linear().col (0);
  board.v = pose.linear().col (1);
  board.center = ground.center + board.half_v * board.v;
  return board;
}

} // namespace

double
RoundShape::area() const
{
  return kind == Kind::Cylinder ? share * (4.0 * pi * radius * height)
         : kind == Kind::Cone   ? share * (pi * radius * std::hypot (radius, height))
         : kind == Kind::Torus  ? share * (4.0 * pi * pi * radius * height)
                                : 2.0 * pi * radius * height;
}

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

Shapes
makeShapes (std::uint32_t seed)
{
  Random random = randomFor (Purpose::Shapes, seed);
  Shapes shapes;
  for (int i = 0; i < 4; ++i)
    shapes.round.push_back (drawSmall (sizes_of_shapes[i], i, random));
  shapes.ground = rectangleAlong (0, 1, {0.0, 2.0, 0.0}, 3.0, 2.0);
  shapes.board = drawBoard (shapes.ground, random);
  shapes.ground.surface = 1;
  shapes.board.surface = 2;
  for (int i = 0; i < 4; ++i)
    shapes.round.push_back (drawLarge (sizes_of_shapes[i], i, random));
  return shapes;
}

SimulatedCloud
scanShapes (const Shapes& shapes,
            std::size_t points,
            double noise_scale,
            std::uint32_t seed)
{
  std::vector<ScannedSurface> surfaces;
  const auto add = [&surfaces] (const auto& shape, SurfaceId surface) {
    surfaces.push_back ({shape.area(), surface, [&shape] (Random& random) {
                           return drawPoint (shape, random);
                         }});
  };
  for (const RoundShape& shape : shapes.round)
    add (shape, no_surface);
  for (const Shape* plane : {&shapes.ground, &shapes.board})
    add (*plane, plane->surface);
  Random random = randomFor (Purpose::ShapesScan, seed);
  return labeledBySize (
      drawPoints (surfaces, points, noise_scale * shapes_sigma, random),
      {shapes.ground.plane(), shapes.board.plane()});
}

} // namespace pcl_ops::simulation
