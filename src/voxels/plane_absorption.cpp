// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "voxels/plane_absorption.h"

#include "geometry/noise_ratios.h"

#include <algorithm>
#include <numeric>
#include <optional>

namespace pcl_ops::internal {

namespace {

/** \brief A plane with the data that decide about its absorption. */
struct Region {
  Plane plane;
  Moments moments;
  /** \brief Squared noise of the plane [m^2]. */
  double squared_noise = 0.0;
  /** \brief Numbers of the planes that it touches, ascending. */
  std::vector<std::size_t> neighbors;
  /** \brief Whether it has got points since its plane was fitted. */
  bool has_grown = false;
};

void
sortNeighbors (Region& region)
{
  std::vector<std::size_t>& all = region.neighbors;
  std::sort (all.begin(), all.end());
  all.erase (std::unique (all.begin(), all.end()), all.end());
}

std::vector<Region>
regionsOf (const VoxelGrid& grid, const BoundedPlanes& planes)
{
  const std::vector<Moments> moments = momentsOfPlanes (grid, planes);
  std::vector<Region> regions;
  for (std::size_t p = 0; p < planes.size(); ++p)
    regions.push_back (
        {planes.planes[p], moments[p], planes.noise[p] * planes.noise[p], {}, false});
  for (std::size_t i = 0; i < grid.size(); ++i) {
    const std::int32_t own = planes.plane_of_voxel[i];
    if (own == no_plane)
      continue;
    std::int32_t last = own;
    for (const std::uint32_t neighbor : grid.neighbors[i]) {
      const std::int32_t other = planes.plane_of_voxel[neighbor];
      if (other != no_plane && other != own && other != last)
        regions[own].neighbors.push_back (other);
      last = other;
    }
  }
  std::for_each (regions.begin(), regions.end(), sortNeighbors);
  return regions;
}

// Mean squared distance of a plane's points to it [m^2], at least its squared noise.
double
squaredRms (const Region& region)
{
  return std::max (region.squared_noise,
                   meanSquaredDistance (region.moments, region.plane));
}

// Mean squared distance of the points of the smaller plane to the larger one, over its
// limit: below 1 both are one plane. The limit is a few times the noise, as points that
// err together make bumps of this height.
double
misfitTo (const Region& larger, const Region& smaller, double noise_factor)
{
  return meanSquaredDistance (smaller.moments, larger.plane) /
         (noise_factor * noise_factor *
          commonSquaredNoise (squaredRms (larger), squaredRms (smaller)));
}

// The larger neighbor that the plane p fits best; p itself if it fits none.
std::size_t
absorberOf (const std::vector<Region>& regions, std::size_t p, double noise_factor)
{
  const Region& own = regions[p];
  std::size_t absorber = p;
  double best = 1.0;
  for (const std::size_t other : own.neighbors) {
    const double count = regions[other].moments.count;
    const bool is_larger =
        count > own.moments.count || (count == own.moments.count && other < p);
    if (!is_larger)
      continue;
    const double misfit = misfitTo (regions[other], own, noise_factor);
    if (!(misfit < best))
      continue;
    best = misfit;
    absorber = other;
  }
  return absorber;
}

// Adds regions to the regions that absorb them, and leaves them empty.
void
join (const std::vector<std::size_t>& goes_into, std::vector<Region>& regions)
{
  for (std::size_t p = 0; p < regions.size(); ++p) {
    if (goes_into[p] == p)
      continue;
    Region& to = regions[goes_into[p]];
    to.has_grown = true;
    to.moments.addAligned (regions[p].moments);
    to.neighbors.insert (
        to.neighbors.end(), regions[p].neighbors.begin(), regions[p].neighbors.end());
    regions[p] = Region();
  }
  for (std::size_t p = 0; p < regions.size(); ++p) {
    Region& region = regions[p];
    for (std::size_t& neighbor : region.neighbors)
      neighbor = goes_into[neighbor];
    sortNeighbors (region);
    region.neighbors.erase (
        std::remove (region.neighbors.begin(), region.neighbors.end(), p),
        region.neighbors.end());
    if (const auto fit = region.has_grown ? fitPlane (region.moments) : std::nullopt)
      region.plane = fit->plane;
    region.has_grown = false;
  }
}

} // namespace

Labels
absorbPlanes (const VoxelGrid& grid, double noise_factor, const BoundedPlanes& planes)
{
  std::vector<Region> regions = regionsOf (grid, planes);
  Labels absorbed (planes.size());
  std::iota (absorbed.begin(), absorbed.end(), 0);
  std::vector<std::size_t> goes_into (planes.size());
  bool has_changed = true;
  while (has_changed) {
    for (std::size_t p = 0; p < regions.size(); ++p)
      goes_into[p] = absorberOf (regions, p, noise_factor);
    // Follows chains of absorptions to their end: each absorber is larger.
    for (std::size_t& to : goes_into)
      while (goes_into[to] != to)
        to = goes_into[to];
    has_changed = false;
    for (std::int32_t& to : absorbed) {
      const std::size_t next = goes_into[to];
      has_changed |= next != static_cast<std::size_t> (to);
      to = static_cast<std::int32_t> (next);
    }
    join (goes_into, regions);
  }
  return absorbed;
}

} // namespace pcl_ops::internal
