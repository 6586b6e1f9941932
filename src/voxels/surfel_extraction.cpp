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

/** \brief For each voxel, whether it is open: it has a surfel flat enough, and no
 * plane.
 */
std::vector<char>
openVoxels (const Surfels& surfels, double max_thickness, const Labels& plane_of_voxel)
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
  /** \brief Largest rms distance of a voxel's points to the plane of a patch, in units
   * of the voxel's noise. */
  double noise_factor;
  /** \brief Cosine of the largest angle between the normals of a plane and a surfel. */
  double min_cosine;
  /** \brief Whether each voxel may be added to a patch: see \ref openVoxels. The caller
   * closes voxels that are done. */
  std::vector<char> is_open;
  /** \brief For each voxel the \ref seed_number of the plane that last tested its
   * points; 0: none did. */
  std::vector<std::uint32_t> last_tested_by =
      std::vector<std::uint32_t> (grid.size(), 0);
  /** \brief How many seeds were used, with the one in use. */
  std::uint32_t seed_number = 0;
  /** \brief Noise of each voxel of a patch [m], as limited by \ref takeIfOnPlane. */
  std::vector<double> noise_of_taken = std::vector<double> (grid.size(), 0.0);

  /** \brief Grows a patch from a seed. Its plane is the seed's until it has four
   * voxels, and is refitted each time the patch has grown by half. */
  SurfelPatch
  growFrom (std::uint32_t seed)
  {
    constexpr std::size_t voxels_of_first_fit = 4; // chosen by hand, as is 3 / 2
    std::size_t next_fit = voxels_of_first_fit;
    ++seed_number;
    Plane plane = surfels[seed]->plane;
    SurfelPatch patch;
    takeIfOnPlane (seed, plane, surfels[seed]->noise, patch);
    for (std::size_t i = 0; i < patch.voxels.size(); ++i) {
      const std::uint32_t voxel = patch.voxels[i];
      for (const std::uint32_t neighbor : grid.neighbors[voxel])
        takeIfOnPlane (neighbor, plane, noise_of_taken[voxel], patch);
      if (patch.voxels.size() < next_fit)
        continue;
      next_fit = patch.voxels.size() * 3 / 2 + 1;
      if (const std::optional<PlaneFit> fit = fitPlane (patch.moments))
        plane = fit->plane;
    }
    return patch;
  }

private:
  // Adds a voxel to a patch if its normal and its points fit the plane; tests its
  // points once per seed. A surfel on two surfaces has more noise than either of them:
  // so the noise of a voxel is limited to like_noise_ratio (1.5) times noise_before
  // [m], that of the neighbor from which the patch reaches the voxel.
  void
  takeIfOnPlane (std::uint32_t voxel,
                 const Plane& plane,
                 double noise_before,
                 SurfelPatch& patch)
  {
    if (last_tested_by[voxel] == seed_number || !is_open[voxel] ||
        std::abs (plane.normal.dot (surfels[voxel]->plane.normal)) < min_cosine)
      return;
    last_tested_by[voxel] = seed_number;
    const double noise =
        std::max (std::min (surfels[voxel]->noise, like_noise_ratio * noise_before),
                  minNoise (grid));
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
  /** \brief As of SurfelSpread. */
  double min_cosine;
  std::vector<char> is_curved = std::vector<char> (grid.size(), 0);

  /** \brief Adds a patch if it is curved together with the curved voxels next to it: a
   * narrow strip of a cylinder, whose other voxels were added before, is flat by
   * itself.
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
    const std::size_t own_voxels = patch.size();
    for (std::size_t i = 0; i < own_voxels; ++i)
      for (const std::uint32_t neighbor : grid.neighbors[patch[i]])
        if (is_curved[neighbor] != 0 &&
            std::abs (plane.normal.dot (surfels[neighbor]->plane.normal)) >
                min_cosine) {
          is_curved[neighbor] = 0;
          patch.push_back (neighbor);
        }
    for (std::size_t i = own_voxels; i < patch.size(); ++i)
      is_curved[patch[i]] = 1;
    return patch;
  }
};

// The open voxels, those with the thinnest surfels first. Of equally thin ones the
// lower index comes first.
Indices
seedsByThickness (const Surfels& surfels, const std::vector<char>& is_open)
{
  Indices seeds;
  for (std::uint32_t voxel = 0; voxel < surfels.size(); ++voxel)
    if (is_open[voxel] != 0)
      seeds.push_back (voxel);
  const auto isThinner = [&] (std::uint32_t one, std::uint32_t other) {
    return surfels[one]->thickness < surfels[other]->thickness;
  };
  std::stable_sort (seeds.begin(), seeds.end(), isThinner);
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
  const double min_cosine = std::cos (parameters.surfels.angle_threshold);
  SurfelSpread spread{grid,
                      surfels,
                      parameters.surfels.noise_factor,
                      min_cosine,
                      openVoxels (surfels, max_thickness, planes.plane_of_voxel)};
  CurvedSurfaces curved{grid, surfels, min_cosine};
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
