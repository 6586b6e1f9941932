// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "voxels/plane_absorption.h"

#include "geometry/noise_ratios.h"

#include <algorithm>
#include <numeric>
#include <optional>

namespace pcl_ops::internal {

namespace {

/** \brief A plane with the data that decide about its absorption: a node of the graph
 * of planes that touch each other. */
struct PlaneNode {
  Plane plane;
  Moments moments;
  /** \brief Squared noise of the plane [m^2]. */
  double squared_noise = 0.0;
  /** \brief Indices of the planes that it touches, ascending, each once. */
  std::vector<std::size_t> neighbors;
  /** \brief Whether it has got points since its plane was fitted. */
  bool has_grown = false;
};

void
makeNeighborsUnique (PlaneNode& node)
{
  std::vector<std::size_t>& neighbors = node.neighbors;
  std::sort (neighbors.begin(), neighbors.end());
  neighbors.erase (std::unique (neighbors.begin(), neighbors.end()), neighbors.end());
}

// The graph of planes: two planes touch if they have adjacent voxels.
std::vector<PlaneNode>
nodesOf (const VoxelGrid& grid, const BoundedPlanes& planes)
{
  const std::vector<Moments> moments = momentsOfPlanes (grid, planes);
  std::vector<PlaneNode> nodes;
  for (std::size_t p = 0; p < planes.size(); ++p)
    nodes.push_back (
        {planes.planes[p], moments[p], planes.noise[p] * planes.noise[p], {}, false});
  for (std::size_t voxel = 0; voxel < grid.size(); ++voxel) {
    const std::int32_t own = planes.plane_of_voxel[voxel];
    if (own == no_plane)
      continue;
    // Successive neighbors mostly are on the same plane: it is added once for them.
    std::int32_t last_other = own;
    for (const std::uint32_t neighbor : grid.neighbors[voxel]) {
      const std::int32_t other = planes.plane_of_voxel[neighbor];
      if (other != no_plane && other != own && other != last_other)
        nodes[own].neighbors.push_back (other);
      last_other = other;
    }
  }
  std::for_each (nodes.begin(), nodes.end(), makeNeighborsUnique);
  return nodes;
}

// Mean squared distance of a plane's points to it [m^2], at least its squared noise.
double
squaredRms (const PlaneNode& node)
{
  return std::max (node.squared_noise, meanSquaredDistance (node.moments, node.plane));
}

// Mean squared distance of the points of the smaller plane to the larger one, divided
// by the largest value allowed: below 1 both are one plane.
double
squaredMisfit (const PlaneNode& larger, const PlaneNode& smaller, double noise_factor)
{
  return meanSquaredDistance (smaller.moments, larger.plane) /
         (noise_factor * noise_factor *
          commonSquaredNoise (squaredRms (larger), squaredRms (smaller)));
}

// The neighbor with more points that plane p fits best; p itself if it fits none. Of
// two planes with equally many points the one that comes first counts as larger.
std::size_t
absorberOf (const std::vector<PlaneNode>& nodes, std::size_t p, double noise_factor)
{
  const PlaneNode& own = nodes[p];
  std::size_t absorber = p;
  double least_misfit = 1.0; // squared
  for (const std::size_t other : own.neighbors) {
    const double count = nodes[other].moments.count;
    const bool is_larger =
        count > own.moments.count || (count == own.moments.count && other < p);
    if (!is_larger)
      continue;
    const double misfit = squaredMisfit (nodes[other], own, noise_factor);
    if (!(misfit < least_misfit))
      continue;
    least_misfit = misfit;
    absorber = other;
  }
  return absorber;
}

// Adds absorbed nodes to the nodes that absorb them, and leaves them empty.
// goes_into[p] is the node that absorbs node p; p itself if none does.
void
addToAbsorbers (const std::vector<std::size_t>& goes_into,
                std::vector<PlaneNode>& nodes)
{
  for (std::size_t p = 0; p < nodes.size(); ++p) {
    if (goes_into[p] == p)
      continue;
    PlaneNode& to = nodes[goes_into[p]];
    to.has_grown = true;
    to.moments.addAligned (nodes[p].moments);
    to.neighbors.insert (
        to.neighbors.end(), nodes[p].neighbors.begin(), nodes[p].neighbors.end());
    nodes[p] = PlaneNode();
  }
}

// Renames absorbed neighbors to the nodes that absorbed them, and refits the planes of
// nodes that have grown.
void
updateNodes (const std::vector<std::size_t>& goes_into, std::vector<PlaneNode>& nodes)
{
  for (std::size_t p = 0; p < nodes.size(); ++p) {
    PlaneNode& node = nodes[p];
    for (std::size_t& neighbor : node.neighbors)
      neighbor = goes_into[neighbor];
    makeNeighborsUnique (node);
    node.neighbors.erase (std::remove (node.neighbors.begin(), node.neighbors.end(), p),
                          node.neighbors.end());
    if (const auto fit = node.has_grown ? fitPlane (node.moments) : std::nullopt)
      node.plane = fit->plane;
    node.has_grown = false;
  }
}

} // namespace

Labels
absorbPlanes (const VoxelGrid& grid, double noise_factor, const BoundedPlanes& planes)
{
  std::vector<PlaneNode> nodes = nodesOf (grid, planes);
  Labels absorber_of (planes.size());
  std::iota (absorber_of.begin(), absorber_of.end(), 0);
  std::vector<std::size_t> goes_into (planes.size());
  bool has_changed = true;
  while (has_changed) {
    for (std::size_t p = 0; p < nodes.size(); ++p)
      goes_into[p] = absorberOf (nodes, p, noise_factor);
    // Follows chains of absorptions to their end: each absorber is larger.
    for (std::size_t& to : goes_into)
      while (goes_into[to] != to)
        to = goes_into[to];
    has_changed = false;
    for (std::int32_t& absorber : absorber_of) {
      const std::size_t next = goes_into[absorber];
      has_changed |= next != static_cast<std::size_t> (absorber);
      absorber = static_cast<std::int32_t> (next);
    }
    addToAbsorbers (goes_into, nodes);
    updateNodes (goes_into, nodes);
  }
  return absorber_of;
}

} // namespace pcl_ops::internal
