// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "leaves/leaf_growing.h"

#include "base/parallel.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pcl_ops::internal {

namespace {

/** \brief The plane a leaf goes to, with its noise there. */
struct Change {
  std::int32_t plane = no_plane;
  double noise = 0.0;
};

// The plane next to a leaf that its points are nearest to.
Change
nearestPlane (const LeafCloud& cloud,
              const LeafPlanes& planes,
              std::uint32_t leaf,
              double max_distance)
{
  Change nearest;
  double least = max_distance * max_distance;
  for (const std::uint32_t k : cloud.neighbors[leaf]) {
    const std::int32_t plane = planes.plane_of_leaf[k];
    if (plane == no_plane)
      continue;
    const double noise = std::max (planes.noise[k], cloud.min_noise[leaf]);
    const double squared =
        meanSquaredDistance (cloud.moments[leaf], planes.planes[plane]) /
        (noise * noise);
    if (squared < least) {
      least = squared;
      nearest = {plane, noise};
    }
  }
  return nearest;
}

// The plane next to a leaf that is likelier than its own; no_plane: none is.
Change
likelierPlane (const LeafCloud& cloud, const LeafPlanes& planes, std::uint32_t leaf)
{
  constexpr double max_squared = 9.0; // three sigma
  const std::int32_t own = planes.plane_of_leaf[leaf];
  const IndexRange around = cloud.neighbors[leaf];
  const bool is_inner =
      std::none_of (around.begin(), around.end(), [&] (std::uint32_t k) {
        return planes.plane_of_leaf[k] != own && planes.plane_of_leaf[k] != no_plane;
      });
  if (is_inner)
    return {};
  const auto squaredIn = [&] (std::int32_t plane, double noise) {
    return meanSquaredDistance (cloud.moments[leaf], planes.planes[plane]) /
           (noise * noise);
  };
  const double own_noise = planes.noise[leaf];
  double least = squaredIn (own, own_noise) + 2.0 * std::log (own_noise);
  Change likelier;
  for (const std::uint32_t k : around) {
    const std::int32_t plane = planes.plane_of_leaf[k];
    if (plane == no_plane || plane == own)
      continue;
    const double noise = std::max (planes.noise[k], cloud.min_noise[leaf]);
    const double squared = squaredIn (plane, noise);
    const double cost = squared + 2.0 * std::log (noise);
    if (squared <= max_squared && cost < least) {
      least = cost;
      likelier = {plane, noise};
    }
  }
  return likelier;
}

// Asks leaves at once, then changes them: their order does not matter.
template <typename Ask>
Indices
changeLeaves (const Indices& asked,
              unsigned threads,
              LeafPlanes& planes,
              std::vector<char>& changed,
              const Ask& ask)
{
  std::vector<Change> changes (asked.size());
  forEach (threads, asked.size(), [&] (std::size_t i) { changes[i] = ask (asked[i]); });
  Indices leaves;
  for (std::size_t i = 0; i < asked.size(); ++i) {
    if (changes[i].plane == no_plane)
      continue;
    const std::uint32_t leaf = asked[i];
    if (planes.plane_of_leaf[leaf] != no_plane)
      changed[planes.plane_of_leaf[leaf]] = 1;
    changed[changes[i].plane] = 1;
    planes.plane_of_leaf[leaf] = changes[i].plane;
    planes.noise[leaf] = changes[i].noise;
    leaves.push_back (leaf);
  }
  return leaves;
}

// Leaves that those touch, each once, ascending.
Indices
around (const LeafCloud& cloud, const Indices& leaves)
{
  Indices all;
  for (const std::uint32_t leaf : leaves)
    all.insert (all.end(), cloud.neighbors[leaf].begin(), cloud.neighbors[leaf].end());
  std::sort (all.begin(), all.end());
  all.erase (std::unique (all.begin(), all.end()), all.end());
  return all;
}

} // namespace

std::vector<char>
growPlanes (const LeafCloud& cloud,
            double max_distance,
            int max_rings,
            unsigned threads,
            LeafPlanes& planes)
{
  std::vector<char> changed (planes.planes.size(), 0);
  Indices open (cloud.size());
  std::iota (open.begin(), open.end(), 0u);
  for (int ring = 0; ring < max_rings && !open.empty(); ++ring) {
    open.erase (std::remove_if (open.begin(),
                                open.end(),
                                [&] (std::uint32_t leaf) {
                                  return planes.plane_of_leaf[leaf] != no_plane;
                                }),
                open.end());
    const Indices taken =
        changeLeaves (open, threads, planes, changed, [&] (std::uint32_t leaf) {
          return nearestPlane (cloud, planes, leaf, max_distance);
        });
    // The answer of other leaves stays the same.
    open = around (cloud, taken);
  }
  return changed;
}

std::vector<char>
relaxLabels (const LeafCloud& cloud, unsigned threads, LeafPlanes& planes)
{
  constexpr int max_passes = 6;
  std::vector<char> changed (planes.planes.size(), 0);
  Indices asked (cloud.size());
  std::iota (asked.begin(), asked.end(), 0u);
  for (int pass = 0; pass < max_passes && !asked.empty(); ++pass) {
    const Indices moved =
        changeLeaves (asked, threads, planes, changed, [&] (std::uint32_t leaf) {
          return planes.plane_of_leaf[leaf] == no_plane
                     ? Change()
                     : likelierPlane (cloud, planes, leaf);
        });
    asked = around (cloud, moved);
  }
  refitPlanes (cloud, planes);
  return changed;
}

} // namespace pcl_ops::internal
