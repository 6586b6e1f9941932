// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "street_things.h"

#include "poses.h"

namespace pcl_ops::simulation {

namespace {

using Eigen::Vector3d;

/** \brief Sizes of a car [m]. */
struct CarSizes {
  double length, width, sill, belt, roof;
};

void
addWheels (Body& car, const CarSizes& size)
{
  constexpr double radius = 0.31, half_width = 0.1;
  /** \brief Of a hub, so that its cap bulges out of the side. */
  constexpr double hub_inside = 0.25;
  for (const double along : {-0.3, 0.3})
    for (const double side : {-1.0, 1.0}) {
      const double x = along * size.length;
      const double y = side * (0.5 * size.width - 0.05 - half_width);
      car.cylinders.push_back ({{x, y, radius}, Vector3d::UnitY(), half_width, radius});
      car.spheres.push_back (
          {{x, side * (0.5 * size.width - hub_inside), radius}, radius});
    }
}

/** \brief Adds a face across the car between two heights or more places along it.
 * \param[in] from,to x and z of its edges */
void
addAcross (Body& car,
           const Eigen::Vector2d& from,
           const Eigen::Vector2d& to,
           double width)
{
  const Eigen::Vector2d middle = 0.5 * (from + to), way = to - from;
  addSurface (car,
              {{middle.x(), 0.0, middle.y()},
               Vector3d (way.x(), 0.0, way.y()).normalized(),
               Vector3d::UnitY(),
               0.5 * way.norm(),
               0.5 * width});
}

/** \brief Slanted windows in front and behind, upright ones beside, a roof on top. */
void
addCabin (Body& car, const CarSizes& size, internal::RandomGenerator& generator)
{
  const double front_foot = drawBetween (generator, 0.2, 0.3) * size.length;
  const double front = drawBetween (generator, 0.0, 0.1) * size.length;
  const double rear = drawBetween (generator, -0.45, -0.3) * size.length;
  const double rear_foot = -0.48 * size.length;
  const double width = size.width - 0.24;
  addAcross (car, {front_foot, size.belt}, {front, size.roof}, width);
  addAcross (car, {rear, size.roof}, {front, size.roof}, width);
  addAcross (car, {rear_foot, size.belt}, {rear, size.roof}, width);
  for (const double side : {-0.5, 0.5})
    addSurface (car,
                {{0.5 * (front + rear), side * width, 0.5 * (size.belt + size.roof)},
                 Vector3d::UnitX(),
                 Vector3d::UnitZ(),
                 0.5 * (front - rear),
                 0.5 * (size.roof - size.belt)});
}

/** \brief Adds leaves, each a small ball, spread evenly in a ball.
 * \param[in] lowest leaves are above [m] */
void
addLeaves (Body& plant,
           const Sphere& crown,
           double lowest,
           internal::RandomGenerator& generator)
{
  constexpr double leaf = 0.03, largest_leaf = 0.08; // radii [m]
  // Such that about a quarter of the rays through the middle pass between the leaves;
  // half of the places are outside the ball.
  const double radii = crown.radius / largest_leaf;
  const auto leaves = int (4.0 * radii * radii);
  for (int i = 0; i < leaves; ++i) {
    const Vector3d place = drawInBox (generator, {-1, -1, -1}, {1, 1, 1});
    const double radius = drawBetween (generator, leaf, largest_leaf);
    const Vector3d center = crown.center + crown.radius * place;
    if (place.norm() <= 1.0 && center.z() > lowest)
      plant.spheres.push_back ({center, radius});
  }
}

Cylinder
standing (double radius, double height)
{
  return {{0.0, 0.0, 0.5 * height}, Vector3d::UnitZ(), 0.5 * height, radius};
}

} // namespace

Body
makeCar (internal::RandomGenerator& generator)
{
  CarSizes size{};
  size.length = drawBetween (generator, 3.8, 4.8);
  size.width = drawBetween (generator, 1.65, 1.85);
  size.sill = drawBetween (generator, 0.2, 0.3);
  size.belt = drawBetween (generator, 0.8, 1.05);
  size.roof = size.belt + drawBetween (generator, 0.5, 0.8);
  Body car;
  addBox (car,
          at (0.0, 0.0, 0.5 * (size.sill + size.belt)),
          {size.length, size.width, size.belt - size.sill},
          HiddenFace::Bottom);
  addCabin (car, size, generator);
  addWheels (car, size);
  return car;
}

Body
makeTree (internal::RandomGenerator& generator)
{
  Body tree;
  const double trunk = drawBetween (generator, 1.6, 2.6);
  const double radius = drawBetween (generator, 1.0, 2.0);
  tree.cylinders.push_back (
      standing (drawBetween (generator, 0.08, 0.25), trunk + 0.5 * radius));
  addLeaves (tree, {{0.0, 0.0, trunk + 0.9 * radius}, radius}, trunk, generator);
  return tree;
}

Body
makeBush (double radius, internal::RandomGenerator& generator)
{
  Body bush;
  addLeaves (bush, {{0.0, 0.0, 0.5 * radius}, radius}, 0.0, generator);
  return bush;
}

Body
makePole (internal::RandomGenerator& generator)
{
  Body pole;
  const double height = drawBetween (generator, 2.5, 8);
  pole.cylinders.push_back (standing (drawBetween (generator, 0.03, 0.1), height));
  return pole;
}

} // namespace pcl_ops::simulation
