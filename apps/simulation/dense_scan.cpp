// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dense_scan.h"

#include "surface_points.h"

namespace pcl_ops::simulation {

SimulatedCloud
scanDensely (const Scene& scene,
             std::size_t points,
             double noise_scale,
             std::uint32_t seed)
{
  const auto forEachShape = [&scene] (const auto& visit) {
    for (const Body& body : scene.bodies) {
      for (const Rectangle& rectangle : body.rectangles)
        visit (rectangle);
      for (const Sphere& sphere : body.spheres)
        visit (sphere);
      for (const Cylinder& cylinder : body.cylinders)
        visit (cylinder);
    }
  };
  internal::RandomGenerator generator = makeGenerator (seed, Purpose::DenseScan);
  SimulatedCloud simulated;
  simulated.cloud =
      drawPoints (forEachShape, points, noise_scale * laser_sigma, generator);
  if (simulated.cloud.empty())
    return simulated;
  simulated.cloud.sensor_origin_.head<3>() = scene.bounds.front().center.cast<float>();
  simulated.planes = labelBySize (simulated.cloud, surfacePlanes (scene));
  return simulated;
}

} // namespace pcl_ops::simulation
