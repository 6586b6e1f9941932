// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bounded/plane_absorption.h"

#include "detection/plane_assignment.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

namespace pcl_ops::internal {

namespace {

// Where a plane touches another one: the noise on that one's side, summed over voxels.
struct Border {
  std::size_t other;
  double squared_noise;
  double voxels;
};

void
addBorder (const Border& added, std::vector<Border>& borders)
{
  const auto place = std::lower_bound (
      borders.begin(),
      borders.end(),
      added.other,
      [] (const Border& border, std::size_t other) { return border.other < other; });
  if (place == borders.end() || place->other != added.other) {
    borders.insert (place, added);
    return;
  }
  place->squared_noise += added.squared_noise;
  place->voxels += added.voxels;
}

// A plane with what decides over its absorption.
struct Territory {
  Plane plane;
  Moments moments;
  /** \brief By the other plane. */
  std::vector<Border> borders;
};

std::vector<Territory>
territoriesOf (const VoxelGrid& grid, const BoundedPlanes& planes)
{
  std::vector<Territory> territories;
  for (const Plane& plane : planes.planes)
    territories.push_back ({plane, Moments(), {}});
  for (std::size_t p = 0; p < planes.beyond.size(); ++p)
    territories[p].moments = planes.beyond[p];
  for (std::size_t i = 0; i < grid.size(); ++i) {
    if (planes.plane_of_voxel[i] == no_plane)
      continue;
    const auto own = static_cast<std::size_t> (planes.plane_of_voxel[i]);
    territories[own].moments.addAligned (grid.moments[i]);
    forNeighboursOnPlanes (
        grid, planes.plane_of_voxel, i, [&] (std::size_t other, std::size_t neighbour) {
          const double noise = planes.noise[neighbour];
          if (other != own)
            addBorder ({other, noise * noise, 1.0}, territories[own].borders);
        });
  }
  return territories;
}

// How much worse than its own plane one plane for both explains either, as a ratio of
// mean squared distances; the smaller may be as noisy as the border is on the other's
// side.
double
misfitOfBoth (const Territory& own, const Territory& other, double squared_noise)
{
  Moments both = other.moments;
  both.addAligned (own.moments);
  const std::optional<PlaneFit> fit = fitPlane (both);
  if (!fit)
    return std::numeric_limits<double>::infinity();
  const auto misfit = [&fit] (const Moments& moments, double least) {
    return meanSquaredDistance (moments, fit->plane) /
           std::max (least, std::numeric_limits<double>::min());
  };
  return std::max (
      misfit (own.moments,
              std::max (squared_noise, meanSquaredDistance (own.moments, own.plane))),
      misfit (other.moments, meanSquaredDistance (other.moments, other.plane)));
}

// The plane each goes into: a larger neighbour that explains it best, or itself.
std::vector<std::size_t>
absorbers (const std::vector<Territory>& territories, double noise_factor)
{
  std::vector<std::size_t> goes_into (territories.size());
  std::iota (goes_into.begin(), goes_into.end(), std::size_t (0));
  for (std::size_t p = 0; p < territories.size(); ++p) {
    const Territory& own = territories[p];
    double best = noise_factor * noise_factor;
    for (const Border& border : own.borders) {
      const Territory& other = territories[border.other];
      const bool is_larger =
          other.moments.count > own.moments.count ||
          (other.moments.count == own.moments.count && border.other < p);
      if (!is_larger)
        continue;
      const double ratio =
          misfitOfBoth (own, other, border.squared_noise / border.voxels);
      if (ratio >= best)
        continue;
      best = ratio;
      goes_into[p] = border.other;
    }
  }
  return goes_into;
}

// Follows a chain of absorptions to its end and closes the gaps it leaves.
std::pair<Labels, std::size_t>
closeGaps (const std::vector<std::size_t>& goes_into)
{
  Labels merged_into (goes_into.size(), no_plane);
  std::size_t number = 0;
  for (std::size_t p = 0; p < goes_into.size(); ++p)
    if (goes_into[p] == p)
      merged_into[p] = static_cast<std::int32_t> (number++);
  for (std::size_t p = 0; p < goes_into.size(); ++p) {
    std::size_t last = p;
    while (goes_into[last] != last)
      last = goes_into[last];
    merged_into[p] = merged_into[last];
  }
  return {merged_into, number};
}

// The territories left when all have gone where they go.
std::vector<Territory>
joined (const std::vector<Territory>& territories,
        const Labels& merged_into,
        std::size_t number)
{
  std::vector<Territory> left (number);
  for (std::size_t p = 0; p < territories.size(); ++p) {
    const auto to = static_cast<std::size_t> (merged_into[p]);
    left[to].moments.addAligned (territories[p].moments);
    for (Border border : territories[p].borders) {
      border.other = static_cast<std::size_t> (merged_into[border.other]);
      if (border.other != to)
        addBorder (border, left[to].borders);
    }
  }
  for (Territory& territory : left)
    if (const std::optional<PlaneFit> fit = fitPlane (territory.moments))
      territory.plane = fit->plane;
  return left;
}

} // namespace

void
absorbPlanes (const VoxelGrid& grid, double noise_factor, BoundedPlanes& planes)
{
  std::vector<Territory> territories = territoriesOf (grid, planes);
  while (true) {
    const auto [merged_into, number] =
        closeGaps (absorbers (territories, noise_factor));
    if (number == territories.size())
      break;
    territories = joined (territories, merged_into, number);
    relabelPlanes (merged_into, number, planes);
  }
  planes.planes.clear();
  for (const Territory& territory : territories)
    planes.planes.push_back (territory.plane);
}

} // namespace pcl_ops::internal
