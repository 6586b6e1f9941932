// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dense_scan.h"

namespace pcl_ops::simulation {

namespace {

using Eigen::Vector3d;

/** \brief A direction across the z axis. */
Vector3d
drawAcross (Random& random)
{
  const double around = random.between (0, 2.0 * pi);
  return {std::cos (around), std::sin (around), 0.0};
}

/** \brief A point of a sphere above some height, in multiples of the radius. Slices of
 * equal height have equal area (Archimedes). */
SurfacePoint
drawAbove (double lowest, const Vector3d& center, double radius, Random& random)
{
  const double z = random.between (lowest, 1);
  const double across = std::sqrt (1.0 - z * z);
  const Vector3d normal = across * drawAcross (random) + z * Vector3d::UnitZ();
  return {center + radius * normal, normal};
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

// The outer side of the ring is longer than the inner one, by the distance from the
// axis.
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
  switch (shape.kind) {
  case RoundShape::Kind::Cylinder:
    return drawPoint (
        Cylinder{shape.center, Vector3d::UnitZ(), shape.height, shape.radius}, random);
  case RoundShape::Kind::Cone:
    return drawOfCone (shape, random);
  case RoundShape::Kind::Torus:
    return drawOfTorus (shape, random);
  default:
    return drawAbove (
        1.0 - shape.height / shape.radius, shape.center, shape.radius, random);
  }
}

} // namespace

double
RoundShape::area() const
{
  switch (kind) {
  case Kind::Cylinder:
    return share * (4.0 * pi * radius * height);
  case Kind::Cone:
    return share * (pi * radius * std::hypot (radius, height));
  case Kind::Torus:
    return share * (4.0 * pi * pi * radius * height);
  default:
    return 2.0 * pi * radius * height;
  }
}

SurfacePoint
drawPoint (const Rectangle& rectangle, Random& random)
{
  const double u = random.between (-1, 1) * rectangle.half_u;
  const double v = random.between (-1, 1) * rectangle.half_v;
  return {rectangle.center + u * rectangle.axis_u + v * rectangle.axis_v,
          rectangle.normal()};
}

SurfacePoint
drawPoint (const Sphere& sphere, Random& random)
{
  return drawAbove (-1.0, sphere.center, sphere.radius, random);
}

SurfacePoint
drawPoint (const Cylinder& cylinder, Random& random)
{
  const Vector3d across = cylinder.axis.unitOrthogonal();
  const double around = random.between (0, 2.0 * pi);
  const Vector3d normal =
      std::cos (around) * across + std::sin (around) * cylinder.axis.cross (across);
  const double along = random.between (-1, 1) * cylinder.half_length;
  return {cylinder.center + along * cylinder.axis + cylinder.radius * normal, normal};
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

SimulatedCloud
scanDensely (const Scene& scene,
             std::size_t points,
             double noise_scale,
             std::uint32_t seed)
{
  const auto forEach = [&scene] (const auto& visit) {
    for (const Body& body : scene.bodies)
      forEachShape (body, visit);
  };
  Random random = randomFor (Purpose::DenseScan, seed);
  SimulatedCloud simulated;
  simulated.cloud = drawPoints (forEach, points, noise_scale * laser_sigma, random);
  if (simulated.cloud.empty())
    return simulated;
  simulated.cloud.sensor_origin_.head<3>() = scene.bounds.front().center.cast<float>();
  simulated.planes = labelBySize (simulated.cloud, surfacePlanes (scene));
  return simulated;
}

} // namespace pcl_ops::simulation
