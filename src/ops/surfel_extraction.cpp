// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ops/surfel_extraction.h"

#include "bounded/bending.h"
#include "bounded/noise_measurement.h"
#include "geometry/noise_ratios.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl_ops::internal {

namespace {

using Surfels = std::vector<std::optional<Surfel>>;

/** \brief Connected voxels on one plane, in the order it reached them. */
struct SurfelPatch {
  Indices voxels;
  Moments moments;
};

/** \brief Spreads a plane from a surfel to those around it. */
class SurfelSpread {
public:
  /** \brief Of each voxel, whether it has a surfel that no plane has yet. */
  std::vector<char> is_open;

  SurfelSpread (const VoxelGrid& grid,
                const Surfels& surfels,
                const OrientedPointSamplingParameters::Surfels& parameters,
                double max_thickness,
                const Labels& plane_of_voxel)
  : is_open (grid.size(), 0)
  , grid_ (grid)
  , surfels_ (surfels)
  , squared_factor_ (parameters.noise_factor * parameters.noise_factor)
  , smallest_cosine_ (std::cos (parameters.angle_threshold))
  , asked_in_ (grid.size(), 0)
  , noise_ (grid.size(), 0.0)
  {
    for (std::size_t i = 0; i < grid.size(); ++i)
      is_open[i] = plane_of_voxel[i] == no_plane && surfels[i] &&
                   surfels[i]->thickness < max_thickness;
  }

  /** \brief What a plane reaches from a seed, refitted when that has grown by half. */
  SurfelPatch
  from (std::uint32_t seed)
  {
    constexpr std::size_t first_fit = 4;
    std::size_t next_fit = first_fit;
    ++round_;
    Plane plane = surfels_[seed]->plane;
    SurfelPatch patch;
    take (seed, plane, surfels_[seed]->noise, patch);
    for (std::size_t i = 0; i < patch.voxels.size(); ++i) {
      const std::uint32_t voxel = patch.voxels[i];
      for (const std::uint32_t neighbor : grid_.neighbors[voxel])
        take (neighbor, plane, noise_[voxel], patch);
      if (patch.voxels.size() < next_fit)
        continue;
      next_fit = patch.voxels.size() * 3 / 2 + 1;
      if (const std::optional<PlaneFit> fit = fitPlane (patch.moments))
        plane = fit->plane;
    }
    return patch;
  }

private:
  // Asks a voxel, once while the plane spreads. What lies on two planes seems noisier
  // than either: the noise of a voxel is at most a little more than that of the voxel
  // the plane comes from.
  void
  take (std::uint32_t voxel,
        const Plane& plane,
        double noise_next_to_it,
        SurfelPatch& patch)
  {
    if (asked_in_[voxel] == round_ || !is_open[voxel] ||
        std::abs (plane.normal.dot (surfels_[voxel]->plane.normal)) < smallest_cosine_)
      return;
    asked_in_[voxel] = round_;
    const double noise =
        std::max (std::min (surfels_[voxel]->noise, like_noise * noise_next_to_it),
                  smallestNoise (grid_));
    if (meanSquaredDistance (grid_.moments[voxel], plane) >
        squared_factor_ * noise * noise)
      return;
    noise_[voxel] = noise;
    patch.voxels.push_back (voxel);
    patch.moments.addAligned (grid_.moments[voxel]);
  }

  const VoxelGrid& grid_;
  const Surfels& surfels_;
  double squared_factor_;
  double smallest_cosine_;
  std::vector<std::uint32_t> asked_in_;
  std::uint32_t round_ = 0;
  std::vector<double> noise_;
};

/** \brief The patches that are no planes. */
struct CurvedSurfaces {
  const VoxelGrid& grid;
  const Surfels& surfels;
  double smallest_cosine;
  std::vector<char> is_curved;

  /** \brief Adds a patch if it is curved together with the curved surfaces it
   * continues: the narrow strip that those leave of a cylinder is flat by itself.
   * \return whether it was */
  bool
  take (const Indices& patch, const PlaneFit& fit)
  {
    if (!isCurved (bendingOf (grid, continued (patch, fit.plane), fit)))
      return false;
    for (const std::uint32_t voxel : patch)
      is_curved[voxel] = 1;
    return true;
  }

  Indices
  continued (Indices patch, const Plane& plane)
  {
    const std::size_t own = patch.size();
    for (std::size_t i = 0; i < own; ++i)
      for (const std::uint32_t neighbor : grid.neighbors[patch[i]])
        if (is_curved[neighbor] != 0 &&
            std::abs (plane.normal.dot (surfels[neighbor]->plane.normal)) >
                smallest_cosine) {
          is_curved[neighbor] = 0;
          patch.push_back (neighbor);
        }
    for (std::size_t i = own; i < patch.size(); ++i)
      is_curved[patch[i]] = 1;
    return patch;
  }
};

// Open voxels with their thickness, the thinnest first.
std::vector<std::pair<double, std::uint32_t>>
byThickness (const Surfels& surfels, const SurfelSpread& spread)
{
  std::vector<std::pair<double, std::uint32_t>> order;
  for (std::uint32_t i = 0; i < surfels.size(); ++i)
    if (spread.is_open[i] != 0)
      order.emplace_back (surfels[i]->thickness, i);
  std::sort (order.begin(), order.end());
  return order;
}

} // namespace

void
extractSurfelPlanes (const VoxelGrid& grid,
                     const Surfels& surfels,
                     const OrientedPointSamplingParameters& parameters,
                     double max_thickness,
                     BoundedPlanes& planes)
{
  planes.plane_of_voxel.resize (grid.size(), no_plane);
  SurfelSpread spread (
      grid, surfels, parameters.surfels, max_thickness, planes.plane_of_voxel);
  CurvedSurfaces curved{grid,
                        surfels,
                        std::cos (parameters.surfels.angle_threshold),
                        std::vector<char> (grid.size(), 0)};
  for (const auto& [thickness, seed] : byThickness (surfels, spread)) {
    if (spread.is_open[seed] == 0)
      continue;
    const SurfelPatch patch = spread.from (seed);
    spread.is_open[seed] = 0;
    if (patch.voxels.size() < parameters.min_inliers)
      continue;
    const std::optional<PlaneFit> fit = fitPlane (patch.moments);
    if (!fit)
      continue;
    for (const std::uint32_t voxel : patch.voxels)
      spread.is_open[voxel] = 0;
    if (curved.take (patch.voxels, *fit))
      continue;
    for (const std::uint32_t voxel : patch.voxels)
      planes.plane_of_voxel[voxel] = static_cast<std::int32_t> (planes.size());
    planes.planes.push_back (fit->plane);
  }
}

} // namespace pcl_ops::internal
