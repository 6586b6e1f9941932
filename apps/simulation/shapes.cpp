// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "shapes.h"

#include <algorithm>
#include <cmath>

namespace pcl_ops::simulation {

namespace {

using Eigen::Vector3d;

using Kind = RoundShape::Kind;

/** \brief From which a size is drawn [m]. */
struct Range {
  double lower, upper;
};

/** \brief Sizes of a small shape and of a large one beside it. */
struct ShapeSizes {
  Kind kind;
  Range small_radius, small_height;
  /** \brief Of a cone in multiples of its radius, of a torus of the smallest one. */
  Range large_height;
};

/** \brief Heights of domes follow from their radii. */
constexpr ShapeSizes sizes_of_shapes[] = {
    {Kind::Dome, {0.3, 0.6}, {0.0, 0.0}, {0.0, 0.0}},
    {Kind::Cylinder, {0.15, 0.4}, {0.5, 1.0}, {0.5, 0.8}},
    {Kind::Cone, {0.3, 0.6}, {0.8, 1.6}, {0.7, 1.0}},
    {Kind::Torus, {0.4, 0.6}, {0.1, 0.2}, {0.3, 0.5}}};

double
draw (const Range& range, Random& random)
{
  return random.between (range.lower, range.upper);
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
  const bool is_sphere = sizes.kind == Kind::Dome;
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
  const double unit = sizes.kind == Kind::Cone    ? shape.radius
                      : sizes.kind == Kind::Torus ? smallest
                                                  : 1.0;
  if (sizes.kind != Kind::Dome)
    shape.height = unit * draw (sizes.large_height, random);
  // 2 to 2.4 m long, so that it bends by far more than the noise however large the
  // radius; of small ones about a third of a turn.
  const double length = std::min (random.between (2.0, 2.4), 2.0 * shape.radius);
  const double share = length / (2.0 * pi * shape.radius);
  const double x = (position - 1.5) * distance;
  if (sizes.kind == Kind::Dome) {
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
Rectangle
drawBoard (const Rectangle& ground, Random& random)
{
  const double turn = random.angle (0, 360), tilt = random.angle (70, 90);
  const Eigen::Isometry3d pose = turnZ (turn) * turnX (tilt);
  Rectangle board;
  board.half_u = 0.5 * random.between (0.8, 1.6);
  board.half_v = 0.5 * random.between (1.2, 2.0);
  board.axis_u = pose.linear().col (0);
  board.axis_v = pose.linear().col (1);
  board.center = ground.center + board.half_v * board.axis_v;
  return board;
}

} // namespace

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
  const auto forEach = [&shapes] (const auto& visit) {
    for (const RoundShape& shape : shapes.round)
      visit (shape);
    visit (shapes.ground);
    visit (shapes.board);
  };
  Random random = randomFor (Purpose::ShapesScan, seed);
  SimulatedCloud simulated;
  simulated.cloud = drawPoints (forEach, points, noise_scale * shapes_sigma, random);
  simulated.planes =
      labelBySize (simulated.cloud, {shapes.ground.plane(), shapes.board.plane()});
  return simulated;
}

} // namespace pcl_ops::simulation
