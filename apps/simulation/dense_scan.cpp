// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dense_scan.h"

#include "poses.h"

#include <algorithm>
#include <cmath>

namespace pcl_ops::simulation {

namespace {

using Eigen::Vector3d;

/** \brief A point of a surface and the direction its distance errs in. */
struct SurfacePoint {
  Vector3d position;
  Vector3d normal;
};

SurfacePoint
drawPoint (const Rectangle& rectangle, internal::RandomGenerator& generator)
{
  const double u = drawBetween (generator, -1, 1) * rectangle.half_u;
  const double v = drawBetween (generator, -1, 1) * rectangle.half_v;
  return {rectangle.center + u * rectangle.axis_u + v * rectangle.axis_v,
          rectangle.normal()};
}

/** \brief Slices of a sphere of equal height have equal area (Archimedes). */
SurfacePoint
drawPoint (const Sphere& sphere, internal::RandomGenerator& generator)
{
  const double z = drawBetween (generator, -1, 1);
  const double around = drawBetween (generator, 0, 2.0 * pi);
  const double across = std::sqrt (1.0 - z * z);
  const Vector3d normal (across * std::cos (around), across * std::sin (around), z);
  return {sphere.center + sphere.radius * normal, normal};
}

/** \brief The side only; its ends are as small as they are few. */
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
area (const Cylinder& cylinder)
{
  return 4.0 * pi * cylinder.radius * cylinder.half_length;
}

SurfaceId
surfaceOf (const Rectangle& rectangle)
{
  return rectangle.surface;
}

SurfaceId
surfaceOf (const Sphere&)
{
  return no_surface;
}

SurfaceId
surfaceOf (const Cylinder&)
{
  return no_surface;
}

template <typename Visitor>
void
forEachShape (const Scene& scene, Visitor visit)
{
  for (const Body& body : scene.bodies) {
    for (const Rectangle& rectangle : body.rectangles)
      visit (rectangle);
    for (const Sphere& sphere : body.spheres)
      visit (sphere);
    for (const Cylinder& cylinder : body.cylinders)
      visit (cylinder);
  }
}

} // namespace

SimulatedCloud
scanDensely (const Scene& scene,
             std::size_t points,
             double noise_scale,
             std::uint32_t seed)
{
  internal::RandomGenerator generator = makeGenerator (seed, Purpose::DenseScan);
  double whole_area = 0.0;
  forEachShape (scene, [&] (const auto& shape) { whole_area += area (shape); });

  SimulatedCloud simulated;
  if (!(whole_area > 0.0))
    return simulated;
  simulated.cloud.reserve (points);
  simulated.cloud.sensor_origin_.head<3>() = scene.bounds.front().center.cast<float>();
  double area_so_far = 0.0;
  forEachShape (scene, [&] (const auto& shape) {
    area_so_far += area (shape);
    // Rounding the running total gives every shape its share and all of them \p points.
    const double share = std::min (1.0, area_so_far / whole_area);
    const auto end = std::size_t (std::llround (share * double (points)));
    while (simulated.cloud.size() < end) {
      const SurfacePoint exact = drawPoint (shape, generator);
      const double error = noise_scale * laser_sigma * drawGaussian (generator);
      pcl::PointXYZL point;
      point.getVector3fMap() = (exact.position + error * exact.normal).cast<float>();
      point.label = surfaceOf (shape);
      simulated.cloud.push_back (point);
    }
  });
  simulated.planes = labelBySize (simulated.cloud, surfacePlanes (scene));
  return simulated;
}

} // namespace pcl_ops::simulation
