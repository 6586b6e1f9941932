// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lidar.h"

#include "draws.h"

#include <cmath>

namespace pcl_ops::simulation {

namespace {

using Eigen::Vector3d;

struct NamedLidar {
  const char* name;
  int beams, steps;
  double highest, lowest; // [degree]
  double farthest;        // [m]
};

constexpr NamedLidar lidars[] = {{"lidar-64", 64, 1900, 2.0, -24.8, 120.0},
                                 {"lidar-32", 32, 1080, 10.0, -30.0, 100.0},
                                 {"lidar-16", 16, 1800, 15.0, -15.0, 100.0},
                                 {"livox", 1, 100'000, 35.0, -35.0, 120.0}};

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
  for (const NamedLidar& lidar : lidars)
    names.emplace_back (lidar.name);
  return names;
}

Lidar
lidarOf (const std::string& name)
{
  Lidar lidar;
  for (const NamedLidar& known : lidars)
    if (name == known.name) {
      lidar.beams = known.beams;
      lidar.steps = known.steps;
      lidar.highest = known.highest;
      lidar.lowest = known.lowest;
      lidar.farthest = known.farthest;
    }
  return lidar;
}

LidarScan
scanAround (const Scene& scene,
            const Lidar& lidar,
            double noise_scale,
            std::uint32_t seed,
            std::size_t number)
{
  internal::RandomGenerator generator = makeGenerator (seed, Purpose::LidarNoise);
  const std::size_t rays = std::size_t (lidar.beams) * lidar.steps;
  LidarScan scan{lidar.beams,
                 std::vector<Vector3d> (rays, Vector3d::Constant (std::nan (""))),
                 std::vector<SurfaceId> (rays, no_surface)};
  const Vector3d eye = lidar.pose.translation();
  for (std::size_t i = 0; i < rays; ++i) {
    const Vector3d ray =
        lidar.isRosette()
            ? rosetteRay (lidar, number * rays + i)
            : rotatingRay (lidar, int (i / lidar.beams), int (i % lidar.beams));
    const Hit hit = castRay (scene, eye, lidar.pose.linear() * ray);
    // Drawn for each ray, so that one reading more leaves the others as they are.
    const double error = noise_scale * lidar_sigma * drawGaussian (generator);
    const double distance = hit.distance + error;
    if (!(distance > 0.0 && distance <= lidar.farthest))
      continue;
    scan.points[i] = distance * ray;
    scan.surface[i] = hit.surface;
  }
  return scan;
}

} // namespace pcl_ops::simulation
