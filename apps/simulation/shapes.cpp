// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "shapes.h"

#include <algorithm>
#include <cmath>

namespace pcl_ops::simulation {

namespace {

using Eigen::Vector3d;

/** \brief Of the large shapes [m]. */
constexpr double smallest_large_radius = 0.6, largest_radius = 5.5;

/** \brief Where the small shape of that position in its row, from 0 to 3, touches
 * z = 0: beside the ground, which begins at y = 0. */
Vector3d
placeOfSmall (int position)
{
  constexpr double distance = 1.8; // room for the two largest [m]
  return {(position - 1.5) * distance, -1.2, 0.0};
}

/** \brief The same of the large shapes, behind the others. */
Vector3d
placeOfLarge (int position)
{
  constexpr double distance = 3.0; // [m]
  return {(position - 1.5) * distance, -3.8, 0.0};
}

Vector3d
up (double height)
{
  return height * Vector3d::UnitZ();
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

/** \brief Of equal chance for each octave. */
double
drawLargeRadius (Random& random)
{
  return smallest_large_radius *
         std::pow (largest_radius / smallest_large_radius, random.unit());
}

/** \brief The axis of a sector whose middle is at that position of its row, at z = 0.
 */
Vector3d
axisBehind (int position, double radius)
{
  return placeOfLarge (position) - radius * Vector3d::UnitY();
}

/** \brief The share of a turn that is 2 to 2.4 m long, so that it bends by far more
 * than the noise however large the radius; of small ones about a third of a turn. */
double
drawShare (double radius, Random& random)
{
  const double length = std::min (random.between (2.0, 2.4), 2.0 * radius);
  return length / (2.0 * pi * radius);
}

RoundShapes
drawSmallShapes (Random& random)
{
  RoundShapes shapes;
  Dome& sphere = shapes.dome;
  sphere.radius = random.between (0.3, 0.6);
  sphere.height = 2.0 * sphere.radius;
  sphere.center = placeOfSmall (0) + up (sphere.radius);

  Cylinder& cylinder = shapes.cylinder.shape;
  cylinder.radius = random.between (0.15, 0.4);
  cylinder.half_length = random.between (0.5, 1.0);
  cylinder.center = placeOfSmall (1) + up (cylinder.half_length);

  Cone& cone = shapes.cone.shape;
  cone.radius = random.between (0.3, 0.6);
  cone.height = random.between (0.8, 1.6);
  cone.apex = placeOfSmall (2) + up (cone.height);

  Torus& torus = shapes.torus.shape;
  torus.radius = random.between (0.4, 0.6);
  torus.tube_radius = random.between (0.1, 0.2);
  torus.center = placeOfSmall (3) + up (torus.tube_radius);
  return shapes;
}

RoundShapes
drawLargeShapes (Random& random)
{
  RoundShapes shapes;
  Dome& dome = shapes.dome;
  dome.radius = drawLargeRadius (random);
  dome.height = dome.radius * (1.0 - std::cos (pi * drawShare (dome.radius, random)));
  dome.center = placeOfLarge (0) + up (dome.height - dome.radius);

  Cylinder& cylinder = shapes.cylinder.shape;
  cylinder.radius = drawLargeRadius (random);
  cylinder.half_length = random.between (0.5, 0.8);
  cylinder.center = axisBehind (1, cylinder.radius) + up (cylinder.half_length);
  shapes.cylinder.share = drawShare (cylinder.radius, random);

  Cone& cone = shapes.cone.shape;
  cone.radius = drawLargeRadius (random);
  cone.height = random.between (0.7, 1.0) * cone.radius;
  cone.apex = axisBehind (2, cone.radius) + up (cone.height);
  shapes.cone.share = drawShare (cone.radius, random);

  Torus& torus = shapes.torus.shape;
  torus.radius = drawLargeRadius (random);
  torus.tube_radius = random.between (0.3, 0.5) * smallest_large_radius;
  torus.center = axisBehind (3, torus.radius) + up (torus.tube_radius);
  shapes.torus.share = drawShare (torus.radius, random);
  return shapes;
}

} // namespace

Shapes
makeShapes (std::uint32_t seed)
{
  Random random = randomFor (Purpose::Shapes, seed);
  Shapes shapes;
  shapes.small = drawSmallShapes (random);
  shapes.ground = rectangleAlong (0, 1, {0.0, 2.0, 0.0}, 3.0, 2.0);
  shapes.board = drawBoard (shapes.ground, random);
  shapes.ground.surface = 1;
  shapes.board.surface = 2;
  shapes.large = drawLargeShapes (random);
  return shapes;
}

SimulatedCloud
scanShapes (const Shapes& shapes,
            std::size_t points,
            double noise_scale,
            std::uint32_t seed)
{
  const auto forEach = [&shapes] (const auto& visit) {
    for (const RoundShapes& row : {shapes.small, shapes.large}) {
      visit (row.dome);
      visit (row.cylinder);
      visit (row.cone);
      visit (row.torus);
    }
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
