// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ops/surfel_extraction.h"

#include "bounded/noise_floors.h"
#include "ops/one_point_ransac.h"
#include "ops/surfel_samples.h"
#include "voxels/voxel_traversal.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl_ops::internal {

namespace {

/** \brief Surfels no plane has yet. */
class SurfelCandidates {
public:
  SurfelCandidates (const VoxelGrid& grid,
                    const std::vector<std::optional<Surfel>>& surfels,
                    const Indices& candidates,
                    const SurfelRansacParameters& parameters)
  : grid_ (grid)
  , surfels_ (surfels)
  , parameters_ (parameters)
  , is_open_ (grid.size(), 1)
  {
    for (const std::uint32_t voxel : candidates)
      samples_.add (
          voxel, grid.moments[voxel], *surfels[voxel], band (*surfels[voxel]));
  }

  std::size_t
  size () const
  {
    return samples_.size();
  }

  bool
  mayHoldPlane () const
  {
    return size() >= parameters_.min_inliers;
  }

  const Plane&
  planeOf (std::uint32_t candidate) const
  {
    return surfels_[samples_.voxels[candidate]]->plane;
  }

  Vote
  leastVote () const
  {
    return {0, static_cast<std::int32_t> (parameters_.min_inliers), size()};
  }

  Vote
  vote (const Plane& hypothesis) const
  {
    return voteOf (samples_, surfelBand (hypothesis));
  }

  bool
  suffices (const Plane& /*hypothesis*/, const Vote& vote) const
  {
    return vote.inliers >= static_cast<std::int32_t> (parameters_.min_inliers);
  }

  Support
  select (const Plane& plane) const
  {
    Support support{plane, surfelsOn (samples_, surfelBand (plane)), Moments()};
    support.moments = momentsOf (grid_, support.inliers);
    return support;
  }

  void
  remove (const Peel& peel)
  {
    for (const std::uint32_t voxel : peel.taken)
      is_open_[voxel] = 0;
    keepOnly (is_open_, samples_);
  }

private:
  double
  band (const Surfel& surfel) const
  {
    return std::clamp (parameters_.noise_factor * surfel.noise,
                       smallestBand (grid_, parameters_.distance_limit),
                       parameters_.distance_limit);
  }

  SurfelBand
  surfelBand (const Plane& plane) const
  {
    return {FloatPlane (plane),
            static_cast<float> (std::cos (parameters_.angle_threshold))};
  }

  const VoxelGrid& grid_;
  const std::vector<std::optional<Surfel>>& surfels_;
  const SurfelRansacParameters& parameters_;
  SurfelSamples samples_;
  std::vector<char> is_open_;
};

// Whether the surfels' normals spread more about the plane's than noise explains, which
// turns the normal of a thick neighbourhood by about its thickness [rad].
bool
isCurved (const Indices& voxels,
          const std::vector<std::optional<Surfel>>& surfels,
          const Plane& plane,
          double largest_normal_spread)
{
  constexpr double spread_of_thickness = 0.6;
  double squared_sines = 0.0;
  double thickness = 0.0;
  for (const std::uint32_t voxel : voxels) {
    const double cosine = plane.normal.dot (surfels[voxel]->plane.normal);
    squared_sines += 1.0 - cosine * cosine;
    thickness += surfels[voxel]->thickness;
  }
  const auto number = static_cast<double> (voxels.size());
  return std::sqrt (squared_sines / number) >
         largest_normal_spread + spread_of_thickness * thickness / number;
}

// The connected parts of a support with theta_N surfels or more.
Indices
largeParts (const VoxelGrid& grid,
            const Indices& support,
            std::size_t min_inliers,
            std::vector<char>& mark)
{
  for (const std::uint32_t voxel : support)
    mark[voxel] = 1;
  Indices large;
  for (const std::uint32_t voxel : support) {
    const Indices part = connectedVoxels (grid, voxel, [&mark] (std::uint32_t other) {
      return std::exchange (mark[other], 0) != 0;
    });
    if (part.size() >= min_inliers)
      large.insert (large.end(), part.begin(), part.end());
  }
  if (large.size() == support.size())
    return support;
  std::sort (large.begin(), large.end());
  return large;
}

Indices
candidatesOf (const std::vector<std::optional<Surfel>>& surfels,
              const Labels& plane_of_voxel,
              double largest_thickness)
{
  Indices candidates;
  for (std::size_t i = 0; i < surfels.size(); ++i)
    if (plane_of_voxel[i] == no_plane && surfels[i] &&
        surfels[i]->thickness < largest_thickness)
      candidates.push_back (static_cast<std::uint32_t> (i));
  return candidates;
}

} // namespace

void
extractSurfelPlanes (const VoxelGrid& grid,
                     const std::vector<std::optional<Surfel>>& surfels,
                     const SurfelRansacParameters& parameters,
                     RandomGenerator& generator,
                     BoundedPlanes& planes)
{
  planes.plane_of_voxel.resize (grid.size(), no_plane);
  planes.noise.resize (grid.size(), 0.0);
  SurfelCandidates samples (
      grid,
      surfels,
      candidatesOf (surfels, planes.plane_of_voxel, parameters.largest_thickness),
      parameters);
  std::vector<char> mark (grid.size(), 0);
  const auto largest_plane =
      [&] (const SurfelCandidates& candidates) -> std::optional<Peel> {
    const std::optional<Plane> hypothesis =
        onePointRansac (candidates, parameters.probability, generator);
    if (!hypothesis)
      return std::nullopt;
    Support support = growSupport (*hypothesis, [&candidates] (const Plane& plane) {
      return candidates.select (plane);
    });
    Indices parts = largeParts (grid, support.inliers, parameters.min_inliers, mark);
    const std::optional<PlaneFit> fit = fitPlane (momentsOf (grid, parts));
    if (fit && !isCurved (parts, surfels, fit->plane, parameters.largest_normal_spread))
      return Peel{std::move (parts), fit->plane};
    return Peel{std::move (support.inliers), std::nullopt};
  };
  for (const ExtractedPlane& found : extractAll (samples, largest_plane)) {
    for (const std::uint32_t voxel : found.inliers) {
      planes.plane_of_voxel[voxel] = static_cast<std::int32_t> (planes.planes.size());
      planes.noise[voxel] = std::max (surfels[voxel]->noise, smallestNoise (grid));
    }
    planes.planes.push_back (found.plane);
  }
}

} // namespace pcl_ops::internal
