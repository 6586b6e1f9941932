// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dense_scan.h"

#include <algorithm>
#include <cmath>

namespace pcl_ops::simulation {

using Eigen::Vector3d;

Vector3d
drawAcross (Random& random)
{
  const double around = random.between (0, 2.0 * pi);
  return {std::cos (around), std::sin (around), 0.0};
}

// Slices of equal height have equal area (Archimedes).
SurfacePoint
drawAbove (double lowest, const Vector3d& center, double radius, Random& random)
{
  const double z = random.between (lowest, 1);
  const double across = std::sqrt (1.0 - z * z);
  const Vector3d normal = across * drawAcross (random) + z * Vector3d::UnitZ();
  return {center + radius * normal, normal};
}

SurfacePoint
drawPoint (const Shape& shape, Random& random)
{
  if (shape.kind == Shape::Kind::Sphere)
    return drawAbove (-1.0, shape.center, shape.half_v, random);
  if (shape.kind == Shape::Kind::Rectangle) {
    const double u = random.between (-1, 1) * shape.half_u;
    const double v = random.between (-1, 1) * shape.half_v;
    return {shape.center + u * shape.u + v * shape.v, shape.normal()};
  }
  const Vector3d across = shape.u.unitOrthogonal();
  const double around = random.between (0, 2.0 * pi);
  const Vector3d normal =
      std::cos (around) * across + std::sin (around) * shape.u.cross (across);
  const double along = random.between (-1, 1) * shape.half_u;
  return {shape.center + along * shape.u + shape.half_v * normal, normal};
}

LabeledCloud
drawPoints (const std::vector<ScannedSurface>& surfaces,
            std::size_t points,
            double sigma,
            Random& random)
{
  LabeledCloud cloud;
  double whole_area = 0.0, area_so_far = 0.0;
  for (const ScannedSurface& surface : surfaces)
    whole_area += surface.area;
  if (!(whole_area > 0.0))
    return cloud;
  cloud.reserve (points);
  for (const ScannedSurface& surface : surfaces) {
    area_so_far += surface.area;
    // Rounding the running total gives every shape its share and all of them \p points.
    const double share = std::min (1.0, area_so_far / whole_area);
    const auto end = std::size_t (std::llround (share * double (points)));
    while (cloud.size() < end) {
      const SurfacePoint exact = surface.draw (random);
      const double error = sigma * random.gaussian();
      cloud.push_back (
          pointAt (exact.position + error * exact.normal, surface.surface));
    }
  }
  return cloud;
}

SimulatedCloud
scanDensely (const Scene& scene,
             std::size_t points,
             double noise_scale,
             std::uint32_t seed)
{
  std::vector<ScannedSurface> surfaces;
  for (const Body& body : scene.bodies)
    for (const Shape::Kind kind :
         {Shape::Kind::Rectangle, Shape::Kind::Sphere, Shape::Kind::Cylinder})
      for (const Shape& shape : body.shapes)
        if (shape.kind == kind)
          surfaces.push_back ({shape.area(), shape.surface, [&shape] (Random& random) {
                                 return drawPoint (shape, random);
                               }});
  Random random = randomFor (Purpose::DenseScan, seed);
  LabeledCloud cloud = drawPoints (surfaces, points, noise_scale * laser_sigma, random);
  if (!cloud.empty())
    cloud.sensor_origin_.head<3>() = scene.bodies.front().middle.cast<float>();
  return labeledBySize (cloud, surfacePlanes (scene));
}

} // namespace pcl_ops::simulation
