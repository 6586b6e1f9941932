// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "voxels/surfels.h"

#include <Eigen/Cholesky>

#include "base/parallel.h"
#include "geometry/noise_ratios.h"
#include "geometry/plane_statistics.h"
#include "geometry/principal_axes.h"
#include "voxels/bounded_planes.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl_ops::internal {

namespace {

// Returns the surfel of the points around a voxel.
// \param[in] axes of their covariance: its ascending values are the variances along the
// normal, the narrow and the long direction [m^2]
Surfel
surfelOfNeighborhood (const Moments& surroundings, const PrincipalAxes& axes)
{
  return {planeThrough (surroundings.centroid(), axes.normal),
          std::sqrt (axes.values[0]),
          std::sqrt (axes.values[0] / axes.values[1])};
}

// Thickness below which a neighborhood is flat. For a voxel that fits its plane, no
// other neighborhood is looked at. Chosen by hand; src/doc/constants.csv has F if none
// counts as flat.
constexpr double flat_thickness = 0.2;

// The voxels of one resolution, and the planes of their neighborhoods.
struct GridLevel {
  const VoxelNeighbors& neighbors;
  double voxel_size;
  /** \brief For each finest voxel the index of the voxel of this level that contains
   * it; empty for the finest level. */
  Indices voxel_of_each_finest;
  /** \brief Number of voxels. */
  std::size_t size;
  std::vector<std::optional<Surfel>> surfels =
      std::vector<std::optional<Surfel>> (size);
  /** \brief Thickness of each of \ref surfels; 1 where there is none, so that it never
   * counts as flatter. In a list of its own, as of most surfels only the thickness is
   * read. */
  std::vector<double> thickness = std::vector<double> (size, 1.0);
  /** \brief For each voxel the index of the voxel with the thinnest surfel among its
   * neighbors and itself. */
  Indices flattest_around = Indices (size);

  std::size_t
  voxelHolding (std::size_t finest_voxel) const
  {
    return voxel_of_each_finest.empty() ? finest_voxel
                                        : voxel_of_each_finest[finest_voxel];
  }
};

// Whether points cover a surface, by the axes of their covariance: if they are narrower
// than a voxel, they form a line, which lies on planes of many directions.
bool
isSurface (const PrincipalAxes& axes, double voxel_size)
{
  return squared_width_of_variance * axes.values[1] >= voxel_size * voxel_size;
}

// Finds the surfels of the voxels begin to end - 1.
void
findSurfelsAmong (const std::vector<Moments>& moments_of_voxels,
                  double min_points,
                  std::size_t begin,
                  std::size_t end,
                  GridLevel& level)
{
  // The voxels with enough points around them, and these points.
  Indices voxels;
  std::vector<Moments> moments_around;
  std::vector<Eigen::Matrix3d> covariances;
  voxels.reserve (end - begin);
  moments_around.reserve (end - begin);
  covariances.reserve (end - begin);
  for (std::size_t i = begin; i < end; ++i) {
    const Moments around = momentsOf (moments_of_voxels, level.neighbors[i]);
    if (around.count < min_points)
      continue;
    voxels.push_back (static_cast<std::uint32_t> (i));
    moments_around.push_back (around);
    covariances.push_back (around.covariance());
  }
  std::vector<PrincipalAxes> axes (voxels.size());
  principalAxes (covariances.data(), voxels.size(), axes.data());
  for (std::size_t i = 0; i < voxels.size(); ++i) {
    if (axes[i].normal.isZero() || !isSurface (axes[i], level.voxel_size))
      continue;
    const Surfel surfel = surfelOfNeighborhood (moments_around[i], axes[i]);
    level.surfels[voxels[i]] = surfel;
    level.thickness[voxels[i]] = surfel.thickness;
  }
}

// Finds the surfels of all voxels of a level, and the flattest one around each.
void
findLevelSurfels (const std::vector<Moments>& moments,
                  double min_points,
                  unsigned threads,
                  GridLevel& level)
{
  // So few that the buffers of findSurfelsAmong stay in the processor's first cache.
  constexpr std::size_t voxels_per_piece = 128;
  parallelFor (threads, level.size, voxels_per_piece, [&] (auto begin, auto end) {
    findSurfelsAmong (moments, min_points, begin, end, level);
  });
  forEach (threads, level.size, [&] (std::size_t i) {
    const IndexRange around = level.neighbors[i];
    level.flattest_around[i] =
        *std::min_element (around.begin(),
                           around.end(),
                           [&level] (std::uint32_t one, std::uint32_t other) {
                             return level.thickness[one] < level.thickness[other];
                           });
  });
}

// The level of the grid, and further ones, each of twice the voxel size of the one
// before; fewer than wanted if one voxel already contains all points.
std::vector<GridLevel>
findLevels (const VoxelGrid& grid, int resolutions, double min_points, unsigned threads)
{
  std::vector<GridLevel> levels;
  levels.push_back ({grid.neighbors, grid.voxel_size, {}, grid.size()});
  findLevelSurfels (grid.moments, min_points, threads, levels.back());
  std::vector<Moments> moments; // of the voxels of the last level
  const std::size_t larger_levels =
      std::min (static_cast<std::size_t> (resolutions - 1), grid.larger.size());
  for (std::size_t i_larger = 0; i_larger < larger_levels; ++i_larger) {
    const LargerVoxels& larger = grid.larger[i_larger];
    moments = momentsOf (i_larger == 0 ? grid.moments : moments, larger);
    Indices voxel_of_each_finest (grid.size());
    for (std::size_t i = 0; i < grid.size(); ++i)
      voxel_of_each_finest[i] = larger.holding[levels.back().voxelHolding (i)];
    levels.push_back ({larger.neighbors,
                       2.0 * levels.back().voxel_size,
                       std::move (voxel_of_each_finest),
                       moments.size()});
    findLevelSurfels (moments, min_points, threads, levels.back());
  }
  return levels;
}

// The flattest plane found so far that fits the points of one of the finest voxels.
struct FlattestPlane {
  /** \brief The points of the finest voxel. */
  const Moments& voxel;
  double min_noise;
  /** \brief The surfel of that plane; nullptr if there is none. */
  const Surfel* flattest_surfel = nullptr;
  /** \brief Thickness of \ref flattest_surfel; 1 if there is none. */
  double thickness = 1.0;

  /** \brief Considers the planes of a voxel and its neighbors, first the flattest one:
   * if the points fit it, the others need no test. */
  void
  considerAll (const GridLevel& level, std::size_t own_voxel)
  {
    const std::uint32_t flattest = level.flattest_around[own_voxel];
    if (level.thickness[flattest] >= thickness)
      return;
    consider (level, flattest);
    if (flattest_surfel == &*level.surfels[flattest])
      return;
    for (const std::uint32_t candidate : level.neighbors[own_voxel])
      consider (level, candidate);
  }

  /** \brief Takes the plane of a voxel if it is flatter than the one taken before, and
   * the points fit it. */
  void
  consider (const GridLevel& level, std::size_t candidate)
  {
    if (level.thickness[candidate] >= thickness)
      return;
    const Surfel& surfel = *level.surfels[candidate];
    const double max_rms = like_noise_ratio * std::max (surfel.noise, min_noise);
    if (meanSquaredDistance (voxel, surfel.plane) >= max_rms * max_rms)
      return;
    flattest_surfel = &surfel;
    thickness = surfel.thickness;
  }
};

// The surfel of one of the finest voxels: a flat one of the finest level that has one,
// or else the flattest of all levels.
std::optional<Surfel>
bestSurfelFor (std::size_t voxel,
               const VoxelGrid& finest,
               const std::vector<GridLevel>& levels)
{
  FlattestPlane plane{finest.moments[voxel], minNoise (finest)};
  for (const GridLevel& level : levels) {
    const std::size_t own_voxel = level.voxelHolding (voxel);
    if (level.thickness[own_voxel] < flat_thickness)
      plane.consider (level, own_voxel);
    // If no plane around is flat enough, a coarser level likely has a better one.
    if (plane.thickness >= flat_thickness &&
        level.thickness[level.flattest_around[own_voxel]] < flat_thickness)
      plane.considerAll (level, own_voxel);
    if (plane.thickness < flat_thickness)
      return *plane.flattest_surfel;
  }
  for (auto level = levels.rbegin(); level != levels.rend(); ++level)
    plane.considerAll (*level, level->voxelHolding (voxel));
  return plane.flattest_surfel ? std::optional<Surfel> (*plane.flattest_surfel)
                               : std::nullopt;
}

// Whether a voxel's surroundings have other_noise_ratio (6) times the noise of its own
// points: the cause is then not noise but several surfaces, such as the two slopes of a
// roof.
bool
hidesSurfaces (const Surfel& surfel, const Moments& voxel, double min_noise)
{
  if (voxel.count < min_points_of_noise ||
      surfel.noise <= other_noise_ratio * min_noise)
    return false;
  const double max_variance = surfel.noise * surfel.noise /
                              (other_noise_ratio * other_noise_ratio) *
                              (voxel.count - parameters_of_plane) / voxel.count;
  // Positive definite exactly if all eigenvalues of the covariance, the variances of
  // the points along their axes, are above this value.
  const Eigen::Matrix3d difference =
      voxel.covariance() - max_variance * Eigen::Matrix3d::Identity();
  return difference.llt().info() != Eigen::Success;
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
  std::vector<std::optional<Surfel>> surfels (grid.size());
  forEach (threads, grid.size(), [&] (std::size_t i) {
    if (!plane_of_voxel.empty() && plane_of_voxel[i] != no_plane)
      return;
    surfels[i] = bestSurfelFor (i, grid, levels);
    if (surfels[i] && hidesSurfaces (*surfels[i], grid.moments[i], minNoise (grid)))
      surfels[i].reset();
  });
  return surfels;
}

} // namespace pcl_ops::internal
