// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "worst_clouds.h"

#include "boards.h"
#include <numbers/random.h>
#include <simulation/dense_scan.h>

#include <algorithm>
#include <cmath>

namespace pcl_ops::benchmark {

namespace {

using apps::Random;
using evaluation::XyzCloud;

constexpr std::uint32_t seed = 1;
/** Of a room [m]. */
constexpr double width = 4.0;

pcl::PointXYZ
toPoint (const Eigen::Vector3d& position)
{
  const Eigen::Vector3f p = position.cast<float>();
  return {p.x(), p.y(), p.z()};
}

/** \param[in] draw gives the position of the next point */
template <typename Draw>
XyzCloud::Ptr
cloudOf (std::size_t points, Draw&& draw)
{
  Random random (seed);
  const XyzCloud::Ptr cloud (new XyzCloud);
  cloud->reserve (points);
  while (cloud->size() < points)
    cloud->push_back (toPoint (draw (random)));
  return cloud;
}

Eigen::Vector3d
drawInCube (Random& random, double edge)
{
  return random.inBox (Eigen::Vector3d::Constant (-edge / 2.0),
                       Eigen::Vector3d::Constant (edge / 2.0));
}

XyzCloud::Ptr
scanOf (const simulation::Scene& scene, std::size_t points, double noise_scale)
{
  const auto scan = simulation::scanDensely (scene, points, noise_scale, seed);
  const XyzCloud::Ptr cloud (new XyzCloud);
  cloud->reserve (scan.cloud.size());
  for (const pcl::PointXYZL& point : scan.cloud)
    cloud->push_back (pcl::PointXYZ (point.x, point.y, point.z));
  return cloud;
}

XyzCloud::Ptr
noiseInACube (std::size_t points)
{
  return cloudOf (points, [] (Random& random) { return drawInCube (random, width); });
}

/** Tilted, so that no voxel has a face along it. */
XyzCloud::Ptr
exactPlane (std::size_t points)
{
  const Eigen::Quaterniond tilt (
      Eigen::AngleAxisd (0.7, Eigen::Vector3d (1.0, 2.0, 3.0).normalized()));
  return cloudOf (points, [tilt] (Random& random) -> Eigen::Vector3d {
    Eigen::Vector3d flat = drawInCube (random, width);
    flat.z() = 1.0;
    return tilt * flat;
  });
}

XyzCloud::Ptr
exactPlanes (std::size_t points)
{
  constexpr unsigned planes = 10;
  return scanOf (makeBoards (planes), points, 0.0);
}

XyzCloud::Ptr
lattice (std::size_t points)
{
  const auto edge =
      static_cast<std::size_t> (std::ceil (std::cbrt (static_cast<double> (points))));
  const double spacing = width / static_cast<double> (edge);
  return cloudOf (
      points,
      [edge, spacing, i = std::size_t (0)] (Random&) mutable -> Eigen::Vector3d {
        const Eigen::Vector3d position =
            spacing * Eigen::Vector3d (static_cast<double> (i % edge),
                                       static_cast<double> (i / edge % edge),
                                       static_cast<double> (i / edge / edge));
        ++i;
        return position;
      });
}

XyzCloud::Ptr
manyPlanes (std::size_t points)
{
  constexpr std::size_t points_per_plane = 10, most_planes = 100'000;
  return scanOf (makeBoards (static_cast<unsigned> (std::clamp<std::size_t> (
                     points / points_per_plane, 1, most_planes))),
                 points,
                 1.0);
}

/** \param[in] lowest, highest power of ten of a point's distance [m] */
XyzCloud::Ptr
logUniformBetween (double lowest, double highest, std::size_t points)
{
  return cloudOf (points, [=] (Random& random) -> Eigen::Vector3d {
    const double power = random.between (lowest, highest);
    return std::pow (10.0, power) * drawInCube (random, 2.0);
  });
}

XyzCloud::Ptr
logUniformPoints (std::size_t points)
{
  return logUniformBetween (-6.0, 6.0, points);
}

/** Hardly one is near another, and a few make the voxels wide that hold the others. */
XyzCloud::Ptr
logUniformPointsApart (std::size_t points)
{
  return logUniformBetween (1.0, 12.0, points);
}

/** All but a few: the voxels are as wide as the few are far. */
XyzCloud::Ptr
pointsInOneVoxel (std::size_t points)
{
  constexpr double edge = 0.01, far_away = 1e6;
  const XyzCloud::Ptr cloud =
      cloudOf (points, [] (Random& random) { return drawInCube (random, edge); });
  for (std::size_t i = 0; i < std::min<std::size_t> (8, points); ++i)
    (*cloud)[i] = toPoint (far_away * Eigen::Vector3d (i & 1, i >> 1 & 1, i >> 2 & 1));
  return cloud;
}

XyzCloud::Ptr
equalPoints (std::size_t points)
{
  return cloudOf (points, [] (Random&) { return Eigen::Vector3d (1, 2, 3); });
}

/** No three of a place make a plane. */
XyzCloud::Ptr
equalPointsByTheHundred (std::size_t points)
{
  const XyzCloud::Ptr places = noiseInACube ((points + 99) / 100);
  return cloudOf (points, [&places, i = std::size_t (0)] (Random&) mutable {
    return Eigen::Vector3d ((*places)[i++ / 100].getVector3fMap().cast<double>());
  });
}

} // namespace

const std::vector<WorstCloud>&
worstClouds ()
{
  static const std::vector<WorstCloud> all{
      {"noise in a cube", noiseInACube},
      {"exact plane", exactPlane},
      {"10 exact planes", exactPlanes},
      {"lattice", lattice},
      {"up to 100000 planes", manyPlanes},
      {"log-uniform points", logUniformPoints},
      {"log-uniform, apart", logUniformPointsApart},
      {"points in one voxel", pointsInOneVoxel},
      {"equal points", equalPoints},
      {"equal by the hundred", equalPointsByTheHundred}};
  return all;
}

} // namespace pcl_ops::benchmark
