// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "leaves/leaf_spreading.h"

#include "leaves/leaf_bending.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl_ops::internal {

namespace {

/** \brief Connected leaves on one plane, in the order it reached them. */
struct LeafPatch {
  Indices leaves;
  Moments moments;
  Plane plane;
};

/** \brief Spreads a plane from a surfel to those around it. */
struct LeafSpread {
  const LeafCloud& cloud;
  const std::vector<LeafSurfel>& surfels;
  const LeafSpreadParameters& parameters;
  std::vector<char> is_open;
  double min_cosine = std::cos (parameters.max_angle);
  std::vector<std::uint32_t> asked_in = std::vector<std::uint32_t> (cloud.size(), 0);
  std::uint32_t round = 0;
  std::vector<double> noise_of = std::vector<double> (cloud.size(), 0.0);

  /** \brief What a plane reaches from a seed; refitted when that has grown by half. */
  LeafPatch
  from (std::uint32_t seed)
  {
    constexpr std::size_t first_fit = 4;
    std::size_t next_fit = first_fit;
    ++round;
    LeafPatch patch;
    patch.plane = surfels[seed].plane;
    take (seed, surfels[seed].noise, patch);
    for (std::size_t i = 0; i < patch.leaves.size(); ++i) {
      const std::uint32_t leaf = patch.leaves[i];
      for (const std::uint32_t neighbor : cloud.neighbors[leaf])
        take (neighbor, noise_of[leaf], patch);
      if (patch.leaves.size() < next_fit)
        continue;
      next_fit = patch.leaves.size() * 3 / 2 + 1;
      refit (patch);
    }
    return patch;
  }

  static bool
  refit (LeafPatch& patch)
  {
    const std::optional<PlaneFit> fit = fitPlane (patch.moments);
    if (fit)
      patch.plane = fit->plane;
    return fit.has_value();
  }

  bool
  isAlong (const Plane& plane, std::uint32_t leaf) const
  {
    return cosineBetween (plane, surfels[leaf].plane) > min_cosine;
  }

private:
  // Asks a leaf, once while the plane spreads. What lies on two planes seems noisier
  // than either: the noise of a leaf is at most a little more than that of the leaf the
  // plane comes from.
  void
  take (std::uint32_t leaf, double noise_next_to_it, LeafPatch& patch)
  {
    constexpr double like = 1.5;
    if (asked_in[leaf] == round || is_open[leaf] == 0 || !isAlong (patch.plane, leaf))
      return;
    asked_in[leaf] = round;
    const double noise = std::max (
        std::min (surfels[leaf].noise, like * noise_next_to_it), cloud.min_noise[leaf]);
    const double limit = parameters.noise_factor * noise;
    if (meanSquaredDistance (cloud.moments[leaf], patch.plane) > limit * limit)
      return;
    noise_of[leaf] = noise;
    patch.leaves.push_back (leaf);
    patch.moments.addAligned (cloud.moments[leaf]);
  }
};

/** \brief The patches that are no planes. */
struct CurvedPatches {
  const LeafSpread& spread;
  std::vector<char> is_curved = std::vector<char> (spread.cloud.size(), 0);

  /** \brief Takes a patch if it is curved together with the curved surfaces it
   * continues: the narrow strip that those leave of a cylinder is flat by itself. */
  bool
  take (const LeafPatch& patch)
  {
    const Indices whole = continued (patch);
    if (!isCurved (bendingOfLeaves (spread.cloud, whole, patch.plane)))
      return false;
    for (const std::uint32_t leaf : patch.leaves)
      is_curved[leaf] = 1;
    return true;
  }

private:
  Indices
  continued (const LeafPatch& patch)
  {
    Indices whole = patch.leaves;
    for (const std::uint32_t leaf : patch.leaves)
      for (const std::uint32_t neighbor : spread.cloud.neighbors[leaf])
        if (is_curved[neighbor] != 0 && spread.isAlong (patch.plane, neighbor)) {
          is_curved[neighbor] = 0; // taken once
          whole.push_back (neighbor);
        }
    for (std::size_t i = patch.leaves.size(); i < whole.size(); ++i)
      is_curved[whole[i]] = 1;
    return whole;
  }
};

// Leaves whose surfels support planes, the flattest first.
std::vector<std::pair<double, std::uint32_t>>
seedsOf (const std::vector<LeafSurfel>& surfels, double max_thickness)
{
  std::vector<std::pair<double, std::uint32_t>> seeds;
  for (std::uint32_t i = 0; i < surfels.size(); ++i)
    if (surfels[i].thickness < max_thickness)
      seeds.emplace_back (surfels[i].thickness, i);
  std::sort (seeds.begin(), seeds.end());
  return seeds;
}

} // namespace

void
spreadPlanes (const LeafCloud& cloud,
              const std::vector<LeafSurfel>& surfels,
              const LeafSpreadParameters& parameters,
              LeafPlanes& planes)
{
  const auto seeds = seedsOf (surfels, parameters.max_thickness);
  LeafSpread spread{cloud, surfels, parameters, std::vector<char> (cloud.size(), 0)};
  for (const auto& thickness_and_leaf : seeds)
    spread.is_open[thickness_and_leaf.second] = 1;
  CurvedPatches curved{spread};
  for (const auto& [thickness, seed] : seeds) {
    if (spread.is_open[seed] == 0)
      continue;
    LeafPatch patch = spread.from (seed);
    spread.is_open[seed] = 0;
    if (static_cast<double> (patch.leaves.size()) < parameters.min_leaves ||
        !LeafSpread::refit (patch))
      continue;
    const bool is_curved = curved.take (patch);
    for (const std::uint32_t leaf : patch.leaves) {
      spread.is_open[leaf] = 0;
      if (is_curved) {
        planes.is_curved[leaf] = 1;
        continue;
      }
      planes.plane_of_leaf[leaf] = static_cast<std::int32_t> (planes.planes.size());
      planes.noise[leaf] = spread.noise_of[leaf];
    }
    if (!is_curved)
      planes.planes.push_back (patch.plane);
  }
}

} // namespace pcl_ops::internal
