// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "shapes.h"

#include "poses.h"

namespace pcl_ops::simulation {

namespace {

/** \brief Middle to middle of neighbouring shapes [m]: room for the two largest. */
constexpr double distance_of_shapes = 1.8;
/** \brief The row of shapes beside the ground, which begins at y = 0 [m]. */
constexpr double row_of_shapes = -1.2;
constexpr double length_of_ground = 6.0;
constexpr double width_of_ground = 4.0;

/** \brief The same of the parts of larger ones, behind the others. */
constexpr double distance_of_large_shapes = 3.0;
constexpr double row_of_large_shapes = -3.8;
constexpr double smallest_large_radius = 0.6;
constexpr double largest_radius = 5.5;

/** \brief Where the shape of that position in its row, from 0 to 3, touches z = 0. */
Eigen::Vector3d
placeInRow (int position)
{
  return {(position - 1.5) * distance_of_shapes, row_of_shapes, 0.0};
}

Eigen::Vector3d
placeOfLarge (int position)
{
  return {(position - 1.5) * distance_of_large_shapes, row_of_large_shapes, 0.0};
}

Eigen::Vector3d
up (double height)
{
  return height * Eigen::Vector3d::UnitZ();
}

Rectangle
makeGround ()
{
  Rectangle ground;
  ground.center = {0.0, 0.5 * width_of_ground, 0.0};
  ground.half_u = 0.5 * length_of_ground;
  ground.half_v = 0.5 * width_of_ground;
  ground.surface = 1;
  return ground;
}

/** \brief A board on the ground, turned about the vertical and leaning back a little.
 */
Rectangle
makeBoard (const Rectangle& ground, internal::RandomGenerator& generator)
{
  const double turn = drawAngle (generator, 0, 360);
  const double tilt = drawAngle (generator, 70, 90);
  const Eigen::Isometry3d pose =
      turned (turn, Eigen::Vector3d::UnitZ()) * turned (tilt, Eigen::Vector3d::UnitX());
  Rectangle board;
  board.half_u = 0.5 * drawBetween (generator, 0.8, 1.6);
  board.half_v = 0.5 * drawBetween (generator, 1.2, 2.0);
  board.axis_u = pose.linear().col (0);
  board.axis_v = pose.linear().col (1);
  board.center = ground.center + board.half_v * board.axis_v;
  board.surface = 2;
  return board;
}

/** \brief Of equal chance for each octave. */
double
drawLargeRadius (internal::RandomGenerator& generator)
{
  return smallest_large_radius * std::pow (largest_radius / smallest_large_radius,
                                           internal::drawUnit (generator));
}

/** \brief The axis of a sector whose middle is at that position of its row, at z = 0.
 */
Eigen::Vector3d
axisBehind (int position, double radius)
{
  return placeOfLarge (position) - radius * Eigen::Vector3d::UnitY();
}

/** \brief The share of a turn that is 2 to 2.4 m long, so that it bends by far more
 * than the noise however large the radius; of small ones about a third of a turn. */
double
drawShare (double radius, internal::RandomGenerator& generator)
{
  const double length = std::min (drawBetween (generator, 2.0, 2.4), 2.0 * radius);
  return length / (2.0 * pi * radius);
}

void
addLargeShapes (Shapes& shapes, internal::RandomGenerator& generator)
{
  Dome& dome = shapes.large_sphere;
  dome.radius = drawLargeRadius (generator);
  dome.height =
      dome.radius * (1.0 - std::cos (pi * drawShare (dome.radius, generator)));
  dome.center = placeOfLarge (0) + up (dome.height - dome.radius);

  Cylinder& cylinder = shapes.large_cylinder.shape;
  cylinder.radius = drawLargeRadius (generator);
  cylinder.half_length = drawBetween (generator, 0.5, 0.8);
  cylinder.center = axisBehind (1, cylinder.radius) + up (cylinder.half_length);
  shapes.large_cylinder.share = drawShare (cylinder.radius, generator);

  Cone& cone = shapes.large_cone.shape;
  cone.radius = drawLargeRadius (generator);
  cone.height = drawBetween (generator, 0.7, 1.0) * cone.radius;
  cone.apex = axisBehind (2, cone.radius) + up (cone.height);
  shapes.large_cone.share = drawShare (cone.radius, generator);

  Torus& torus = shapes.large_torus.shape;
  torus.radius = drawLargeRadius (generator);
  torus.tube_radius = drawBetween (generator, 0.3, 0.5) * smallest_large_radius;
  torus.center = axisBehind (3, torus.radius) + up (torus.tube_radius);
  shapes.large_torus.share = drawShare (torus.radius, generator);
}

} // namespace

Shapes
makeShapes (std::uint32_t seed)
{
  internal::RandomGenerator generator = makeGenerator (seed, Purpose::Shapes);
  Shapes shapes;
  shapes.sphere.radius = drawBetween (generator, 0.3, 0.6);
  shapes.sphere.center = placeInRow (0) + up (shapes.sphere.radius);
  shapes.cylinder.radius = drawBetween (generator, 0.15, 0.4);
  shapes.cylinder.half_length = drawBetween (generator, 0.5, 1.0);
  shapes.cylinder.center = placeInRow (1) + up (shapes.cylinder.half_length);
  shapes.cone.radius = drawBetween (generator, 0.3, 0.6);
  shapes.cone.height = drawBetween (generator, 0.8, 1.6);
  shapes.cone.apex = placeInRow (2) + up (shapes.cone.height);
  shapes.torus.radius = drawBetween (generator, 0.4, 0.6);
  shapes.torus.tube_radius = drawBetween (generator, 0.1, 0.2);
  shapes.torus.center = placeInRow (3) + up (shapes.torus.tube_radius);
  shapes.ground = makeGround();
  shapes.board = makeBoard (shapes.ground, generator);
  addLargeShapes (shapes, generator);
  return shapes;
}

SimulatedCloud
scanShapes (const Shapes& shapes,
            std::size_t points,
            double noise_scale,
            std::uint32_t seed)
{
  const auto forEachShape = [&shapes] (const auto& visit) {
    visit (shapes.sphere);
    visit (shapes.cylinder);
    visit (shapes.cone);
    visit (shapes.torus);
    visit (shapes.large_sphere);
    visit (shapes.large_cylinder);
    visit (shapes.large_cone);
    visit (shapes.large_torus);
    visit (shapes.ground);
    visit (shapes.board);
  };
  internal::RandomGenerator generator = makeGenerator (seed, Purpose::ShapesScan);
  SimulatedCloud simulated;
  simulated.cloud =
      drawPoints (forEachShape, points, noise_scale * shapes_sigma, generator);
  std::vector<Plane> planes;
  for (const Rectangle& flat : {shapes.ground, shapes.board})
    planes.push_back (planeThrough (flat.center, flat.normal()));
  simulated.planes = labelBySize (simulated.cloud, planes);
  return simulated;
}

} // namespace pcl_ops::simulation
