// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "voxels/surfel_extraction.h"

#include "geometry/noise_ratios.h"
#include "voxels/bending.h"

#include <algorithm>
#include <cmath>

namespace pcl_ops::internal {

namespace {

using Surfels = std::vector<std::optional<Surfel>>;

/** \brief Connected voxels on one plane, in the order in which growth reached them. */
struct SurfelPatch {
  Indices voxels;
  Moments moments;
};

/** \brief For each voxel, whether it is open: with a surfel flat enough, on no plane.
 */
std::vector<char>
openSurfels (const Surfels& surfels, double max_thickness, const Labels& plane_of_voxel)
{
  std::vector<char> is_open (surfels.size());
  for (std::size_t i = 0; i < surfels.size(); ++i)
    is_open[i] = plane_of_voxel[i] == no_plane && surfels[i] &&
                 surfels[i]->thickness < max_thickness;
  return is_open;
}

/** \brief Grows a plane from a seed surfel over neighboring surfels. */
struct SurfelSpread {
  const VoxelGrid& grid;
  const Surfels& surfels;
  double noise_factor, smallest_cosine;
  /** \brief For each voxel; the caller closes those that are done. */
  std::vector<char> is_open;
  /** \brief For each voxel the number of the seed whose plane last tested its points.
   */
  std::vector<std::uint32_t> last_tested_by =
      std::vector<std::uint32_t> (grid.size(), 0);
  /** \brief Number of the seed in use, from 1 up. */
  std::uint32_t seed_number = 0;
  /** \brief Noise of each voxel of a patch [m], as it was limited by \ref take. */
  std::vector<double> noise_of_taken = std::vector<double> (grid.size(), 0.0);

  /** \brief Grows a patch from a seed. Its plane is the seed's until it has four
   * voxels, and is refitted each time the patch has grown by half. */
  SurfelPatch
  growFrom (std::uint32_t seed)
  {
    constexpr std::size_t voxels_of_first_fit = 4;
    std::size_t next_fit = voxels_of_first_fit;
    ++seed_number;
    Plane plane = surfels[seed]->plane;
    SurfelPatch patch;
    take (seed, plane, surfels[seed]->noise, patch);
    for (std::size_t i = 0; i < patch.voxels.size(); ++i) {
      const std::uint32_t voxel = patch.voxels[i];
      for (const std::uint32_t neighbor : grid.neighbors[voxel])
        take (neighbor, plane, noise_of_taken[voxel], patch);
      if (patch.voxels.size() < next_fit)
        continue;
      next_fit = patch.voxels.size() * 3 / 2 + 1;
      if (const std::optional<PlaneFit> fit = fitPlane (patch.moments))
        plane = fit->plane;
    }
    return patch;
  }

private:
  // Adds a voxel if its normal and its points fit the plane; tests its points once per
  // seed. Surfels on two planes seem noisier than either plane: so the noise of a voxel
  // is limited to like_noise times that of the voxel from which the patch reaches it.
  void
  take (std::uint32_t voxel,
        const Plane& plane,
        double noise_next_to_it,
        SurfelPatch& patch)
  {
    if (last_tested_by[voxel] == seed_number || !is_open[voxel] ||
        std::abs (plane.normal.dot (surfels[voxel]->plane.normal)) < smallest_cosine)
      return;
    last_tested_by[voxel] = seed_number;
    const double noise =
        std::max (std::min (surfels[voxel]->noise, like_noise * noise_next_to_it),
                  smallestNoise (grid));
    if (meanSquaredDistance (grid.moments[voxel], plane) >
        noise_factor * noise_factor * noise * noise)
      return;
    noise_of_taken[voxel] = noise;
    patch.voxels.push_back (voxel);
    patch.moments.addAligned (grid.moments[voxel]);
  }
};

/** \brief The voxels of curved patches, which are no planes. */
struct CurvedSurfaces {
  const VoxelGrid& grid;
  const Surfels& surfels;
  double smallest_cosine;
  std::vector<char> is_curved = std::vector<char> (grid.size(), 0);

  /** \brief Adds a patch if it is curved together with the curved voxels next to it: a
   * narrow strip that remains of a cylinder is flat by itself.
   * \return whether the patch is curved */
  bool
  addIfCurved (const Indices& patch, const PlaneFit& fit)
  {
    if (!isCurved (bendingOf (grid, withCurvedNeighbors (patch, fit.plane), fit)))
      return false;
    for (const std::uint32_t voxel : patch)
      is_curved[voxel] = 1;
    return true;
  }

private:
  // The voxels of a patch, then the curved voxels next to it with similar normals. The
  // latter are marked as not curved while the list grows, so that it has each once.
  Indices
  withCurvedNeighbors (Indices patch, const Plane& plane)
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

// The voxels with open surfels, the thinnest first; lower indices first among equal
// ones.
Indices
seedsByThickness (const Surfels& surfels, const std::vector<char>& is_open)
{
  Indices seeds;
  for (std::uint32_t voxel = 0; voxel < surfels.size(); ++voxel)
    if (is_open[voxel] != 0)
      seeds.push_back (voxel);
  std::stable_sort (seeds.begin(), seeds.end(), [&] (std::uint32_t a, std::uint32_t b) {
    return surfels[a]->thickness < surfels[b]->thickness;
  });
  return seeds;
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
  const double smallest_cosine = std::cos (parameters.surfels.angle_threshold);
  SurfelSpread spread{grid,
                      surfels,
                      parameters.surfels.noise_factor,
                      smallest_cosine,
                      openSurfels (surfels, max_thickness, planes.plane_of_voxel)};
  CurvedSurfaces curved{grid, surfels, smallest_cosine};
  for (const std::uint32_t seed : seedsByThickness (surfels, spread.is_open)) {
    if (spread.is_open[seed] == 0)
      continue;
    const SurfelPatch patch = spread.growFrom (seed);
    spread.is_open[seed] = 0;
    if (patch.voxels.size() < parameters.min_samples)
      continue;
    const std::optional<PlaneFit> fit = fitPlane (patch.moments);
    if (!fit)
      continue;
    for (const std::uint32_t voxel : patch.voxels)
      spread.is_open[voxel] = 0;
    if (curved.addIfCurved (patch.voxels, *fit))
      continue;
    for (const std::uint32_t voxel : patch.voxels)
      planes.plane_of_voxel[voxel] = static_cast<std::int32_t> (planes.size());
    planes.planes.push_back (fit->plane);
  }
}

} // namespace pcl_ops::internal
