// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "round_furniture.h"

#include "poses.h"

namespace pcl_ops::simulation {

using Eigen::Vector3d;

namespace {

Furniture
makeBall (internal::RandomGenerator& generator)
{
  const double radius = drawBetween (generator, 0.1, 0.35);
  Furniture ball{{}, {2.0 * radius, 2.0 * radius}};
  ball.body.spheres.push_back ({{0.0, 0.0, radius}, radius});
  return ball;
}

Furniture
makeBin (internal::RandomGenerator& generator)
{
  const double radius = drawBetween (generator, 0.1, 0.2);
  const double half_length = drawBetween (generator, 0.15, 0.3);
  Furniture bin{{}, {2.0 * radius, 2.0 * radius}};
  bin.body.cylinders.push_back (
      {{0.0, 0.0, half_length}, Vector3d::UnitZ(), half_length, radius});
  return bin;
}

Furniture
makeLamp (internal::RandomGenerator& generator)
{
  const double half_length = drawBetween (generator, 0.6, 0.85);
  const double shade = drawBetween (generator, 0.12, 0.22);
  Furniture lamp{{}, {2.0 * shade, 2.0 * shade}};
  lamp.body.cylinders.push_back (
      {{0.0, 0.0, half_length}, Vector3d::UnitZ(), half_length, 0.02});
  lamp.body.cylinders.push_back ({{0.0, 0.0, 0.015}, Vector3d::UnitZ(), 0.015, 0.15});
  lamp.body.spheres.push_back ({{0.0, 0.0, 2.0 * half_length}, shade});
  return lamp;
}

Furniture
makeRolledCarpet (internal::RandomGenerator& generator)
{
  const double radius = drawBetween (generator, 0.08, 0.15);
  const double length = drawBetween (generator, 0.8, 1.6);
  Furniture carpet{{}, {length, 2.0 * radius}};
  carpet.body.cylinders.push_back (
      {{0.0, 0.0, radius}, Vector3d::UnitX(), 0.5 * length, radius});
  return carpet;
}

} // namespace

Furniture
makeRoundClutter (internal::RandomGenerator& generator)
{
  constexpr Furniture (*kinds[]) (internal::RandomGenerator&) = {
      makeBall, makeBin, makeLamp, makeRolledCarpet};
  return kinds[internal::drawBelow (generator, 4)](generator);
}

} // namespace pcl_ops::simulation
