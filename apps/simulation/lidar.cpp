// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lidar.h"

#include <cmath>

namespace pcl_ops::simulation {

namespace {

using Eigen::Vector3d;

const std::vector<Lidar>&
knownLidars ()
{
  static const std::vector<Lidar> lidars = {{"lidar-64", 64, 1900, 2.0, -24.8, 120.0},
                                            {"lidar-32", 32, 1080, 10.0, -30.0, 100.0},
                                            {"lidar-16", 16, 1800, 15.0, -15.0, 100.0},
                                            {"livox", 1, 100'000, 35.0, -35.0, 120.0}};
  return lidars;
}

Vector3d
rotatingRay (const Lidar& lidar, int step, int beam)
{
  const double share = lidar.beams > 1 ? double (beam) / (lidar.beams - 1) : 0.0;
  const double elevation =
      (lidar.highest + share * (lidar.lowest - lidar.highest)) * pi / 180.0;
  const double azimuth = -2.0 * pi * step / lidar.steps;
  return {std::cos (elevation) * std::cos (azimuth),
          std::cos (elevation) * std::sin (azimuth),
          std::sin (elevation)};
}

/** \brief The beam goes through two prisms that turn against each other, each of which
 * bends it by half of what both do together. */
Vector3d
rosetteRay (const Lidar& lidar, std::size_t ray)
{
  // Of a Livox Mid-40: the rosette is closed after half a minute.
  constexpr double turns_of_first = 7294.0 / 60.0, turns_of_second = -4664.0 / 60.0;
  constexpr double rays_a_second = 1e5;
  const double time = double (ray) / rays_a_second;
  const double first = 2.0 * pi * turns_of_first * time;
  const double second = 2.0 * pi * turns_of_second * time;
  const double bent = 0.25 * (lidar.highest - lidar.lowest) * pi / 180.0;
  const double left = bent * (std::cos (first) + std::cos (second));
  const double up = bent * (std::sin (first) + std::sin (second));
  const double angle = std::hypot (left, up);
  const double sine = angle > 0.0 ? std::sin (angle) / angle : 1.0;
  return {std::cos (angle), sine * left, sine * up};
}

} // namespace

std::vector<std::string>
lidarNames ()
{
  std::vector<std::string> names;
  for (const Lidar& lidar : knownLidars())
    names.push_back (lidar.name);
  return names;
}

Lidar
lidarOf (const std::string& name)
{
  for (const Lidar& lidar : knownLidars())
    if (lidar.name == name)
      return lidar;
  return {};
}

Scan
scanAround (const Scene& scene,
            const Lidar& lidar,
            const Eigen::Isometry3d& pose,
            double noise_scale,
            std::uint32_t seed,
            std::size_t number)
{
  Random random = randomFor (Purpose::LidarNoise, seed);
  Scan scan;
  scan.columns = std::size_t (lidar.steps);
  scan.rows = std::size_t (lidar.beams);
  scan.column_by_column = true;
  const std::size_t rays = scan.columns * scan.rows;
  scan.points.assign (rays, Vector3d::Constant (std::nan ("")));
  scan.surfaces.assign (rays, no_surface);
  const Vector3d eye = pose.translation();
  for (std::size_t i = 0; i < rays; ++i) {
    const Vector3d ray =
        lidar.isRosette()
            ? rosetteRay (lidar, number * rays + i)
            : rotatingRay (lidar, int (i / scan.rows), int (i % scan.rows));
    const Hit hit = castRay (scene, eye, pose.linear() * ray);
    // Drawn for each ray, so that one reading more leaves the others as they are.
    const double error = noise_scale * lidar_sigma * random.gaussian();
    const double distance = hit.distance + error;
    if (!(distance > 0.0 && distance <= lidar.farthest))
      continue;
    scan.points[i] = distance * ray;
    scan.surfaces[i] = hit.surface;
  }
  return scan;
}

} // namespace pcl_ops::simulation
