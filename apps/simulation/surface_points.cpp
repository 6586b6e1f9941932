// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "surface_points.h"

namespace pcl_ops::simulation {

namespace {

using Eigen::Vector3d;

/** \brief A direction across the z axis. */
Vector3d
drawAcross (internal::RandomGenerator& generator)
{
  const double around = drawBetween (generator, 0, 2.0 * pi);
  return {std::cos (around), std::sin (around), 0.0};
}

/** \brief A point of a sphere above some height, in multiples of the radius. Slices of
 * equal height have equal area (Archimedes). */
SurfacePoint
drawAbove (double lowest,
           const Vector3d& center,
           double radius,
           internal::RandomGenerator& generator)
{
  const double z = drawBetween (generator, lowest, 1);
  const double around = drawBetween (generator, 0, 2.0 * pi);
  const double across = std::sqrt (1.0 - z * z);
  const Vector3d normal (across * std::cos (around), across * std::sin (around), z);
  return {center + radius * normal, normal};
}

} // namespace

SurfacePoint
drawPoint (const Rectangle& rectangle, internal::RandomGenerator& generator)
{
  const double u = drawBetween (generator, -1, 1) * rectangle.half_u;
  const double v = drawBetween (generator, -1, 1) * rectangle.half_v;
  return {rectangle.center + u * rectangle.axis_u + v * rectangle.axis_v,
          rectangle.normal()};
}

SurfacePoint
drawPoint (const Sphere& sphere, internal::RandomGenerator& generator)
{
  return drawAbove (-1.0, sphere.center, sphere.radius, generator);
}

SurfacePoint
drawPoint (const Dome& dome, internal::RandomGenerator& generator)
{
  return drawAbove (
      1.0 - dome.height / dome.radius, dome.center, dome.radius, generator);
}

SurfacePoint
drawPoint (const Cylinder& cylinder, internal::RandomGenerator& generator)
{
  const Vector3d across = cylinder.axis.unitOrthogonal();
  const double around = drawBetween (generator, 0, 2.0 * pi);
  const Vector3d normal =
      std::cos (around) * across + std::sin (around) * cylinder.axis.cross (across);
  const double along = drawBetween (generator, -1, 1) * cylinder.half_length;
  return {cylinder.center + along * cylinder.axis + cylinder.radius * normal, normal};
}

// The share of area above grows with the square of the distance from the apex.
SurfacePoint
drawPoint (const Cone& cone, internal::RandomGenerator& generator)
{
  const Vector3d across = drawAcross (generator);
  const double down = std::sqrt (internal::drawUnit (generator));
  const Vector3d normal = cone.height * across + cone.radius * Vector3d::UnitZ();
  return {cone.apex + down * (cone.radius * across - cone.height * Vector3d::UnitZ()),
          normal.normalized()};
}

// The outer side of the ring is longer than the inner one, by the distance from the
// axis.
SurfacePoint
drawPoint (const Torus& torus, internal::RandomGenerator& generator)
{
  const Vector3d across = drawAcross (generator);
  for (;;) {
    const double around_tube = drawBetween (generator, 0, 2.0 * pi);
    const double outward = std::cos (around_tube);
    const double longest = torus.radius + torus.tube_radius;
    if (!drawChance (generator, (torus.radius + torus.tube_radius * outward) / longest))
      continue;
    const Vector3d normal =
        outward * across + std::sin (around_tube) * Vector3d::UnitZ();
    return {torus.center + torus.radius * across + torus.tube_radius * normal, normal};
  }
}

SurfacePoint
foldIntoSector (const SurfacePoint& whole, const Vector3d& on_axis, double share)
{
  const Vector3d local = whole.position - on_axis;
  const double around = std::atan2 (-local.x(), local.y());
  const Eigen::AngleAxisd turn ((share - 1.0) * around, Vector3d::UnitZ());
  return {on_axis + turn * local, turn * whole.normal};
}

double
area (const Rectangle& rectangle)
{
  return rectangle.area();
}

double
area (const Sphere& sphere)
{
  return 4.0 * pi * sphere.radius * sphere.radius;
}

double
area (const Dome& dome)
{
  return 2.0 * pi * dome.radius * dome.height;
}

double
area (const Cylinder& cylinder)
{
  return 4.0 * pi * cylinder.radius * cylinder.half_length;
}

double
area (const Cone& cone)
{
  return pi * cone.radius * std::hypot (cone.radius, cone.height);
}

double
area (const Torus& torus)
{
  return 4.0 * pi * pi * torus.radius * torus.tube_radius;
}

} // namespace pcl_ops::simulation
