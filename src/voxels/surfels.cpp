// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "voxels/surfels.h"

#include <Eigen/Cholesky>

#include "base/parallel.h"
#include "geometry/noise_ratios.h"
#include "geometry/principal_axes.h"
#include "voxels/bounded_planes.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl_ops::internal {

namespace {

Surfel
normalOf (const Moments& surroundings, const PrincipalAxes& axes)
{
  return {planeThrough (surroundings.centroid(), axes.normal),
          std::sqrt (axes.values[0]),
          std::sqrt (axes.values[0] / axes.values[1])};
}

// Thickness of a neighborhood over its width up to which no other is looked at.
constexpr double flat_enough_of_voxels = 0.2;

// The voxels of one resolution, and the planes around them.
struct GridLevel {
  const VoxelNeighbors& neighbors;
  double voxel_size;
  /** \brief Empty for the finest level. */
  Indices voxel_of_finest;
  std::size_t size;
  std::vector<std::optional<Surfel>> normals =
      std::vector<std::optional<Surfel>> (size);
  /** \brief Of the normals, apart because most are looked at for this only; 1 where
   * there is none. */
  std::vector<double> thickness = std::vector<double> (size, 1.0);
  /** \brief For each voxel the one around it, or itself, with the least thickness. */
  Indices flattest_around = Indices (size);

  std::size_t
  voxelHolding (std::size_t finest_voxel) const
  {
    return voxel_of_finest.empty() ? finest_voxel : voxel_of_finest[finest_voxel];
  }
};

// Whether points cover a surface: what is narrower than a voxel is a line, and has a
// plane along any direction.
bool
isSurface (const PrincipalAxes& axes, double voxel_size)
{
  // Of a strip that is evenly covered the width is sqrt (12) deviations.
  return 12.0 * axes.values[1] >= voxel_size * voxel_size;
}

// The normals of a range of voxels.
void
findNormals (const std::vector<Moments>& of_voxels,
             double min_points,
             std::size_t begin,
             std::size_t end,
             GridLevel& level)
{
  Indices voxels;
  std::vector<Moments> moments;
  std::vector<Eigen::Matrix3d> covariances;
  voxels.reserve (end - begin);
  moments.reserve (end - begin);
  covariances.reserve (end - begin);
  for (std::size_t i = begin; i < end; ++i) {
    const Moments around = momentsOf (of_voxels, level.neighbors[i]);
    if (around.count < min_points)
      continue;
    voxels.push_back (static_cast<std::uint32_t> (i));
    moments.push_back (around);
    covariances.push_back (around.covariance());
  }
  std::vector<PrincipalAxes> axes (voxels.size());
  principalAxes (covariances.data(), voxels.size(), axes.data());
  for (std::size_t i = 0; i < voxels.size(); ++i) {
    if (axes[i].normal.isZero() || !isSurface (axes[i], level.voxel_size))
      continue;
    const Surfel normal = normalOf (moments[i], axes[i]);
    level.normals[voxels[i]] = normal;
    level.thickness[voxels[i]] = normal.thickness;
  }
}

// Finds the planes around the voxels of a level.
void
findAllNormals (const std::vector<Moments>& moments,
                double min_points,
                unsigned threads,
                GridLevel& level)
{
  // So few that what is noted of them stays in the processor's first cache.
  constexpr std::size_t voxels_at_once = 128;
  parallelFor (threads, level.size, voxels_at_once, [&] (auto begin, auto end) {
    findNormals (moments, min_points, begin, end, level);
  });
  forEach (threads, level.size, [&] (std::size_t i) {
    const IndexRange around = level.neighbors[i];
    level.flattest_around[i] = *std::min_element (
        around.begin(), around.end(), [&level] (std::uint32_t a, std::uint32_t b) {
          return level.thickness[a] < level.thickness[b];
        });
  });
}

// Grids, each of twice the voxel size of the one before, as far as the octree goes.
std::vector<GridLevel>
findLevels (const VoxelGrid& grid, int resolutions, double min_points, unsigned threads)
{
  std::vector<GridLevel> levels;
  levels.push_back ({grid.neighbors, grid.voxel_size, {}, grid.size()});
  findAllNormals (grid.moments, min_points, threads, levels.back());
  std::vector<Moments> moments;
  const auto wanted = static_cast<std::size_t> (resolutions - 1);
  for (std::size_t l = 0; l < std::min (wanted, grid.larger.size()); ++l) {
    const LargerVoxels& larger = grid.larger[l];
    moments = momentsOf (l == 0 ? grid.moments : moments, larger);
    Indices voxel_of_finest (grid.size());
    for (std::size_t i = 0; i < grid.size(); ++i)
      voxel_of_finest[i] = larger.holding[levels.back().voxelHolding (i)];
    levels.push_back ({larger.neighbors,
                       2.0 * levels.back().voxel_size,
                       std::move (voxel_of_finest),
                       moments.size()});
    findAllNormals (moments, min_points, threads, levels.back());
  }
  return levels;
}

// The flattest of the planes around a voxel of a level that the finest voxel lies in.
struct FlattestPlane {
  const Moments& voxel;
  double smallest_noise;
  const Surfel* best = nullptr;
  double thickness = 1.0;

  /** \brief Considers the planes around a voxel of a level. The flattest may mostly
   * serve, and spares a look at the others. */
  void
  considerAll (const GridLevel& level, std::size_t at)
  {
    const std::uint32_t flattest = level.flattest_around[at];
    if (level.thickness[flattest] >= thickness)
      return;
    consider (level, flattest);
    if (best == &*level.normals[flattest])
      return;
    for (const std::uint32_t candidate : level.neighbors[at])
      consider (level, candidate);
  }

  void
  consider (const GridLevel& level, std::size_t candidate)
  {
    if (level.thickness[candidate] >= thickness)
      return;
    const Surfel& normal = *level.normals[candidate];
    const double limit = like_noise * std::max (normal.noise, smallest_noise);
    if (meanSquaredDistance (voxel, normal.plane) >= limit * limit)
      return;
    best = &normal;
    thickness = normal.thickness;
  }
};

std::optional<Surfel>
surfelOf (std::size_t voxel,
          const VoxelGrid& finest,
          const std::vector<GridLevel>& levels)
{
  FlattestPlane plane{finest.moments[voxel], smallestNoise (finest)};
  for (const GridLevel& level : levels) {
    const std::size_t at = level.voxelHolding (voxel);
    if (level.thickness[at] < flat_enough_of_voxels)
      plane.consider (level, at);
    // Where nothing around is flat enough, a coarser level is likely to have better.
    if (plane.thickness >= flat_enough_of_voxels &&
        level.thickness[level.flattest_around[at]] < flat_enough_of_voxels)
      plane.considerAll (level, at);
    if (plane.thickness < flat_enough_of_voxels)
      return *plane.best;
  }
  for (auto level = levels.rbegin(); level != levels.rend(); ++level)
    plane.considerAll (*level, level->voxelHolding (voxel));
  return plane.best ? std::optional<Surfel> (*plane.best) : std::nullopt;
}

// Whether a voxel's surroundings are far noisier than its own points: not noise, then,
// but surfaces finer than the voxels, say the two slopes of a roof.
bool
hidesSurfaces (const Surfel& surfel, const Moments& voxel, double smallest_noise)
{
  if (voxel.count < min_points_of_noise || surfel.noise <= other_noise * smallest_noise)
    return false;
  // A plane fits its own three points without noise: n - 3 are left to measure it.
  const double squared_limit = surfel.noise * surfel.noise /
                               (other_noise * other_noise) * (voxel.count - 3.0) /
                               voxel.count;
  // Positive definite exactly if the least eigenvalue of the covariance is above.
  const Eigen::Matrix3d rest =
      voxel.covariance() - squared_limit * Eigen::Matrix3d::Identity();
  return rest.llt().info() != Eigen::Success;
}

} // namespace

std::vector<std::optional<Surfel>>
findSurfels (const VoxelGrid& grid,
             int resolutions,
             double min_points,
             unsigned threads,
             const Labels& plane_of_voxel)
{
  const std::vector<GridLevel> levels =
      findLevels (grid, resolutions, min_points, threads);
  std::vector<std::optional<Surfel>> normals (grid.size());
  forEach (threads, grid.size(), [&] (std::size_t i) {
    if (!plane_of_voxel.empty() && plane_of_voxel[i] != no_plane)
      return;
    normals[i] = surfelOf (i, grid, levels);
    if (normals[i] &&
        hidesSurfaces (*normals[i], grid.moments[i], smallestNoise (grid)))
      normals[i].reset();
  });
  return normals;
}

} // namespace pcl_ops::internal
