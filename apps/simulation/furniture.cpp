// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "furniture.h"

#include "poses.h"

namespace pcl_ops::simulation {

namespace {

using Eigen::Vector3d;

void
addStandingBox (Body& body, double x, double y, const Vector3d& size)
{
  addBox (body, at (x, y, 0.5 * size.z()), size, HiddenFace::Bottom);
}

void
addUprightCylinder (Body& body, const Vector3d& foot, double height, double radius)
{
  body.cylinders.push_back ({foot + 0.5 * height * Vector3d::UnitZ(),
                             Vector3d::UnitZ(),
                             0.5 * height,
                             radius});
}

/** \brief A slab on four round legs; \p size is its outer extent. */
void
addSlabOnLegs (Body& body, const Vector3d& size, double thickness, double leg_radius)
{
  addBox (
      body, at (0.0, 0.0, size.z() - 0.5 * thickness), {size.x(), size.y(), thickness});
  for (const double side_x : {-0.5, 0.5})
    for (const double side_y : {-0.5, 0.5}) {
      const double inset = 3.0 * leg_radius;
      const Vector3d foot (side_x * (size.x() - inset), side_y * (size.y() - inset), 0);
      addUprightCylinder (body, foot, size.z() - thickness, leg_radius);
    }
}

/** \brief Books standing in a row from \p start along x. */
void
addBooks (Body& body,
          const Vector3d& start,
          double width,
          internal::RandomGenerator& generator)
{
  double x = 0.0;
  while (x < width) {
    const Vector3d size = drawInBox (generator, {0.02, 0.14, 0.18}, {0.045, 0.2, 0.26});
    x += size.x();
    addBox (body,
            at (start.x() + x - 0.5 * size.x(), start.y(), start.z() + 0.5 * size.z()),
            size,
            HiddenFace::Bottom);
  }
}

void
addMonitor (Body& body, const Vector3d& foot, internal::RandomGenerator& generator)
{
  const Vector3d size (drawBetween (generator, 0.45, 0.7), 0.04, 0.36);
  addUprightCylinder (body, foot, 0.2, 0.03);
  addUprightCylinder (body, foot, 0.015, 0.12);
  const double tilt = drawAngle (generator, 0, 12);
  const double yaw = drawAngle (generator, -25, 25);
  addBox (body,
          at (foot.x(), foot.y() + 0.05, foot.z() + 0.1 + 0.5 * size.z()) *
              turned (yaw, Vector3d::UnitZ()) * turned (tilt, Vector3d::UnitX()),
          size);
}

void
addLaptop (Body& body, const Vector3d& hinge, internal::RandomGenerator& generator)
{
  const double width = 0.34;
  const double depth = 0.24;
  const double thickness = 0.018;
  const Eigen::Isometry3d pose =
      Eigen::Isometry3d (Eigen::Translation3d (hinge)) *
      turned (drawAngle (generator, -30, 30), Vector3d::UnitZ());
  addBox (body,
          pose * at (0.0, 0.5 * depth, 0.5 * thickness),
          {width, depth, thickness},
          HiddenFace::Bottom);
  addBox (body,
          pose * turned (drawAngle (generator, 5, 35), Vector3d::UnitX()) *
              at (0.0, 0.0, 0.5 * depth),
          {width, 0.008, depth});
}

} // namespace

Furniture
makeTable (internal::RandomGenerator& generator)
{
  const Vector3d size = drawInBox (generator, {0.8, 0.6, 0.42}, {1.8, 0.95, 0.78});
  Furniture table{{}, size.head<2>()};
  addSlabOnLegs (table.body, size, 0.035, 0.03);
  const Vector3d mug (drawBetween (generator, -0.3, 0.3), 0.1, size.z());
  addUprightCylinder (table.body, mug, 0.1, 0.04);
  table.body.spheres.push_back ({mug + Vector3d (0.2, -0.2, 0.08), 0.08});
  return table;
}

Furniture
makeDesk (internal::RandomGenerator& generator)
{
  const Vector3d size = drawInBox (generator, {1.2, 0.65, 0.7}, {1.8, 0.85, 0.76});
  Furniture desk{{}, size.head<2>()};
  addSlabOnLegs (desk.body, size, 0.03, 0.03);
  const double drawers_width = 0.42;
  addStandingBox (desk.body,
                  0.5 * (size.x() - drawers_width) - 0.03,
                  0.0,
                  {drawers_width, size.y() - 0.1, size.z() - 0.1});
  addMonitor (desk.body, {-0.2 * size.x(), -0.15, size.z()}, generator);
  addLaptop (desk.body, {0.25 * size.x(), -0.05, size.z()}, generator);
  addBooks (desk.body, {0.02 * size.x(), -0.2, size.z()}, 0.12, generator);
  addUprightCylinder (desk.body, {-0.4 * size.x(), 0.15, size.z()}, 0.1, 0.04);
  return desk;
}

Furniture
makeCupboard (internal::RandomGenerator& generator)
{
  const Vector3d size = drawInBox (generator, {0.5, 0.35, 0.7}, {1.4, 0.6, 2.1});
  Furniture cupboard{{}, size.head<2>()};
  addStandingBox (cupboard.body, 0.0, 0.0, size);
  return cupboard;
}

Furniture
makeShelf (internal::RandomGenerator& generator)
{
  const double thickness = 0.025;
  const int boards = 3 + int (internal::drawBelow (generator, 3));
  const double pitch = drawBetween (generator, 0.33, 0.4);
  const Vector3d size (drawBetween (generator, 0.7, 1.2), 0.3, boards * pitch);
  Furniture shelf{{}, size.head<2>()};
  for (const double side : {-0.5, 0.5})
    addStandingBox (shelf.body, side * size.x(), 0.0, {thickness, size.y(), size.z()});
  addStandingBox (shelf.body, 0.0, -0.5 * size.y(), {size.x(), thickness, size.z()});
  for (int i = 0; i <= boards; ++i)
    addBox (shelf.body, at (0.0, 0.0, i * pitch), {size.x(), size.y(), thickness});
  for (int i = 1; i < boards; ++i) {
    const Vector3d start (-0.45 * size.x(), -0.03, i * pitch + 0.5 * thickness);
    if (drawChance (generator, 0.6))
      addBooks (shelf.body, start, drawBetween (generator, 0.1, 0.6), generator);
  }
  return shelf;
}

Furniture
makeBed (internal::RandomGenerator& generator)
{
  const Vector3d size = drawInBox (generator, {0.9, 2.0, 0.4}, {1.6, 2.0, 0.6});
  const double headboard = 0.06;
  Furniture bed{{}, size.head<2>()};
  addStandingBox (
      bed.body, 0.0, 0.5 * headboard, {size.x(), size.y() - headboard, size.z()});
  addStandingBox (bed.body,
                  0.0,
                  0.5 * (headboard - size.y()),
                  {size.x(), headboard, size.z() + 0.4});
  const Vector3d pillow (0.0, -0.5 * size.y() + 0.3, size.z() + 0.02);
  bed.body.cylinders.push_back ({pillow, Vector3d::UnitX(), 0.4 * size.x(), 0.12});
  return bed;
}

Furniture
makeSofa (internal::RandomGenerator& generator)
{
  const double width = drawBetween (generator, 1.4, 2.2);
  const double depth = 0.85;
  const double arm = 0.18;
  const double seat_height = drawBetween (generator, 0.38, 0.46);
  Furniture sofa{{}, {width, depth}};
  addStandingBox (sofa.body, 0.0, 0.0, {width - 2.0 * arm, depth, seat_height});
  for (const double side : {-0.5, 0.5})
    addStandingBox (
        sofa.body, side * (width - arm), 0.0, {arm, depth, seat_height + 0.2});
  addBox (sofa.body,
          at (0.0, -0.5 * depth + 0.22, seat_height + 0.2) *
              turned (drawAngle (generator, 8, 20), Vector3d::UnitX()),
          {width - 2.0 * arm, 0.15, 0.5});
  return sofa;
}

Furniture
makeChair (internal::RandomGenerator& generator)
{
  const Vector3d size = drawInBox (generator, {0.4, 0.4, 0.42}, {0.5, 0.5, 0.48});
  Furniture chair{{}, size.head<2>()};
  addSlabOnLegs (chair.body, size, 0.04, 0.018);
  addBox (chair.body,
          at (0.0, -0.5 * size.y(), size.z() + 0.22) *
              turned (drawAngle (generator, 3, 15), Vector3d::UnitX()),
          {size.x(), 0.03, 0.42});
  return chair;
}

Furniture
makeCartons (internal::RandomGenerator& generator)
{
  const Vector3d lower = drawInBox (generator, {0.35, 0.35, 0.25}, {0.7, 0.6, 0.5});
  Furniture cartons{{}, lower.head<2>()};
  addStandingBox (cartons.body, 0.0, 0.0, lower);
  if (drawChance (generator, 0.5)) {
    const Vector3d upper = drawBetween (generator, 0.5, 0.8) * lower;
    addBox (cartons.body,
            at (0.0, 0.0, lower.z() + 0.5 * upper.z()) *
                turned (drawAngle (generator, -40, 40), Vector3d::UnitZ()),
            upper,
            HiddenFace::Bottom);
  }
  return cartons;
}

} // namespace pcl_ops::simulation
