// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slabs.h"

namespace pcl_ops::simulation {

namespace {

/** Adds the two large faces of a slab; its narrow faces have no points.
 * \param[in] face one of the two
 * \param[in] thickness from this face to the other one, along its normal [m] */
void
addSlab (Body& body, const Shape& face, double thickness)
{
  body.addSurface (face);
  Shape back = face;
  back.center += thickness * face.normal();
  body.addSurface (back);
}

} // namespace

Scene
makeSlabs (Seed seed)
{
  // Lengths and heights [m]; the sensor is at height 0.
  constexpr double thinnest = 0.04;
  constexpr double thickest = 0.15;
  constexpr double floor = -0.9;
  constexpr double edge_of_floor = 4.0;
  constexpr double height_of_back_wall = 2.5;
  Random random = randomFor (Purpose::Slabs, seed);
  Body body;
  // A wall that was seen from both sides.
  const double length = random.between (2, 4);
  const double height = random.between (2, 2.5);
  const double thickness_of_wall = random.between (thinnest, thickest);
  addSlab (
      body,
      makeRectangle ({1.0, 1.2, floor + 0.5 * height}, {length, 0, 0}, {0, 0, height}),
      thickness_of_wall);
  // The board, level as the top of a table.
  const double width = random.between (0.8, 1.6);
  const double depth = random.between (0.6, 1.0);
  const double thickness_of_board = random.between (thinnest, thickest);
  addSlab (body,
           makeRectangle (
               {0.6, -0.5, random.between (-0.4, 0.3)}, {width, 0, 0}, {0, depth, 0}),
           thickness_of_board);
  // The floor and a wall at its back edge, each seen from one side.
  const double middle = 0.5; // of the floor, along x and y
  const Vector3d along_x (edge_of_floor, 0, 0);
  body.addSurface (
      makeRectangle ({middle, middle, floor}, along_x, {0, edge_of_floor, 0}));
  const Vector3d middle_of_wall (
      middle, middle - 0.5 * edge_of_floor, floor + 0.5 * height_of_back_wall);
  body.addSurface (
      makeRectangle (middle_of_wall, along_x, {0, 0, height_of_back_wall}));
  Scene scene;
  scene.add (body, Isometry3d::Identity());
  return scene;
}

double
drawPointCountOfSlabs (Seed seed)
{
  constexpr double fewest = 1e4;
  constexpr double most = 3e5;
  Random random = randomFor (Purpose::PointsOfSlabs, seed);
  return std::floor (drawLogUniform (fewest, most, random));
}

SimulatedCloud
scanSlabs (const Scene& scene, std::size_t points, double noise, Seed seed)
{
  Random random = randomFor (Purpose::SlabsScan, seed);
  const Shapes& shapes = scene.bodies.front().shapes;
  return labeledBySize (drawPoints (shapes, points, noise * slabs_sigma, random),
                        surfacePlanes (scene));
}

} // namespace pcl_ops::simulation
