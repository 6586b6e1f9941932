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

/** \brief Where the shape of that position in the row, from 0 to 3, touches z = 0. */
Eigen::Vector3d
placeInRow (int position)
{
  return {(position - 1.5) * distance_of_shapes, row_of_shapes, 0.0};
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
