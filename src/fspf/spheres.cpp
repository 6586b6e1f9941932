// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fspf/spheres.h"

#include "voxels/voxel_grid.h"
#include "voxels/voxel_size.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace pcl_ops::internal {

namespace {

/** \brief Finds the points within one radius, known beforehand, of any of the points:
 * they are sorted into voxels of that size, or larger ones where the points lie so far
 * apart that most would be nearly empty. That takes a fraction of the time a kd-tree
 * takes to build. */
struct FixedRadiusSearch {
  float squared_radius;
  VoxelNeighbors neighbors_of_voxel;
  /** \brief Position of each voxel's first point, and where the last voxel ends. */
  Indices voxel_begin;
  /** \brief Voxel by voxel. */
  Coordinates points;

  FixedRadiusSearch (const Coordinates& positions, double radius, unsigned threads)
  : squared_radius (static_cast<float> (radius * radius))
  {
    // Voxels that hold next to no points cost, too.
    constexpr double points_per_voxel = 16.0;
    const double most_voxels =
        std::max (1.0, static_cast<double> (positions.size()) / points_per_voxel);
    const double edge = std::max (radius, voxelSizeFor (positions, most_voxels));
    VoxelizedPoints voxelized = voxelize (positions, edge, threads);
    connect (voxelized.grid, threads);
    neighbors_of_voxel = std::move (voxelized.grid.neighbors);
    voxel_begin = std::move (voxelized.grid.first_point);
    voxel_begin.push_back (static_cast<std::uint32_t> (positions.size()));
    points = selected (positions, voxelized.order);
  }

  std::size_t
  find (std::uint32_t point, Indices& sphere) const
  {
    const float x = points.x[point], y = points.y[point], z = points.z[point];
    const auto next_voxel =
        std::upper_bound (voxel_begin.begin(), voxel_begin.end(), point);
    const auto own_voxel =
        static_cast<std::size_t> (next_voxel - voxel_begin.begin()) - 1;
    std::size_t number = 0, looked_at = 0;
    for (const std::uint32_t neighbor : neighbors_of_voxel[own_voxel]) {
      const std::uint32_t* const voxel = &voxel_begin[neighbor];
      looked_at += voxel[1] - voxel[0];
      sphere.resize (number + (voxel[1] - voxel[0]));
      for (std::uint32_t i = voxel[0]; i < voxel[1]; ++i) {
        const float dx = points.x[i] - x, dy = points.y[i] - y, dz = points.z[i] - z;
        // Written always, counted if near: no branch to mispredict.
        sphere[number] = i;
        number += dx * dx + dy * dy + dz * dz <= squared_radius;
      }
    }
    sphere.resize (number);
    return looked_at;
  }
};

Spheres
spheresInVoxels (const Points& points, double radius, unsigned threads)
{
  const auto search =
      std::make_shared<const FixedRadiusSearch> (points, radius, threads);
  return {search->points, [search] (std::uint32_t center, Indices& sphere) {
            return search->find (center, sphere);
          }};
}

Spheres
spheresByUsersSearch (const DetectorInput& input, const Points& points, double radius)
{
  constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  Indices place_of (input.cloud.size, none);
  for (std::size_t i = 0; i < points.size(); ++i)
    place_of[static_cast<std::size_t> (points.indexOf (i))] =
        static_cast<std::uint32_t> (i);
  return {points,
          [&points,
           radius,
           search = input.search_over (points.index),
           place_of = std::move (place_of)] (std::uint32_t center, Indices& sphere) {
            pcl::Indices neighbors;
            std::vector<float> squared_distances;
            search.within (
                points.indexOf (center), radius, neighbors, squared_distances);
            sphere.clear();
            for (const pcl::index_t neighbor : neighbors)
              if (place_of[static_cast<std::size_t> (neighbor)] != none)
                sphere.push_back (place_of[static_cast<std::size_t> (neighbor)]);
            return sphere.size();
          }};
}

} // namespace

Spheres
spheresAround (const DetectorInput& input,
               const Points& points,
               double radius,
               unsigned threads)
{
  return input.search_over && points.size() > 0
             ? spheresByUsersSearch (input, points, radius)
             : spheresInVoxels (points, radius, threads);
}

} // namespace pcl_ops::internal
