// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "voxels/voxel_choice.h"

#include "cloud/voxel_size.h"
#include "geometry/principal_axes.h"
#include "voxels/bounded_planes.h"
#include <pcl_ops/oriented_point_sampling.h>
#include <pcl_ops/voxel_size.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace pcl_ops::internal {

namespace {

// Lower quartile over voxels of the rms distance of a voxel's points to the plane
// fitted to them [m]. Voxels with too few points do not count, nor do voxels without
// any noise, as they are in the steps of a quantized depth. 0 if no voxel counts.
double
noiseOfFlatVoxels (const VoxelGrid& grid)
{
  constexpr double min_noise_share = 1e-4; // of the voxel size
  std::vector<Eigen::Matrix3d> covariances;
  for (const Moments& voxel : grid.moments)
    if (voxel.count >= min_points_of_noise)
      covariances.push_back (voxel.covariance());
  std::vector<PrincipalAxes> axes_of_voxels (covariances.size());
  principalAxes (covariances.data(), covariances.size(), axes_of_voxels.data());
  std::vector<float> noises;
  for (const PrincipalAxes& axes : axes_of_voxels)
    if (const double noise = std::sqrt (axes.values[0]);
        noise > min_noise_share * grid.voxel_size)
      noises.push_back (static_cast<float> (noise));
  const auto lower_quartile = noises.begin() + noises.size() / 4;
  std::nth_element (noises.begin(), lower_quartile, noises.end());
  return noises.empty() ? 0.0 : *lower_quartile;
}

// Number of points in the voxel of a point, on average over all points. It is far above
// the average over voxels if some parts of the cloud are far denser than others.
double
meanOverPoints (const VoxelGrid& grid)
{
  double points = 0.0;
  double squares = 0.0; // sum over voxels of the squared number of points
  for (const Moments& voxel : grid.moments) {
    points += voxel.count;
    squares += voxel.count * voxel.count;
  }
  return squares / points;
}

// The voxel size [m] for the noise of a cloud, at most that of the grid. In denser
// clouds voxels hold more points, as noise does not shrink with voxels. If there is
// next to no noise, smaller voxels tell more. One size is too large near a lidar and
// too small far from it: a cloud of uneven density gets the voxels that suit its dense
// parts, and sparse parts are searched in voxels of their own, see \ref sparsePoints.
// The numbers were chosen by hand; src/doc/constants.csv has F with others.
double
voxelSizeByNoise (const VoxelGrid& grid)
{
  // Fewest points in a voxel of the result, on average over points.
  constexpr double enough_points = 12.0;
  // A grid with fewer points in a voxel, on average over points, keeps its voxel size;
  // in a cloud of uneven density one with fewer than enough_points.
  constexpr double many_points = 128.0;
  // Smallest ratio of the means over points and over voxels in a cloud of uneven
  // density.
  constexpr double min_contrast = 1.7;
  // Largest noise in units of the voxel size.
  constexpr double max_noise_share = 0.014;
  // Smallest voxel size in units of that of the grid: however dense one part is, the
  // voxels have to suit the whole cloud.
  constexpr double min_size_share = 1.0 / 16.0;
  const double mean_points = meanOverPoints (grid);
  const bool is_uneven = mean_points > min_contrast * meanPointsPerVoxel (grid);
  if (mean_points < (is_uneven ? enough_points : many_points))
    return grid.voxel_size;
  // Points lie on surfaces: their number in a voxel is proportional to its squared
  // edge.
  const double size_share =
      std::max (min_size_share, std::sqrt (enough_points / mean_points));
  return roundNumber (std::clamp (noiseOfFlatVoxels (grid) / max_noise_share,
                                  size_share * grid.voxel_size,
                                  grid.voxel_size));
}

} // namespace

double
wantedVoxels (std::size_t points, double sampling_rate, double min_points_per_voxel)
{
  // Chosen by hand, as is reference_points.
  constexpr double voxels_per_sample = 2.0 / 3.0;
  // In a cloud of this many points, sampling_rate is the share that would be samples.
  constexpr double reference_points = 300000.0;
  const auto point_count = static_cast<double> (points);
  const double samples =
      sampling_rate * reference_points * std::cbrt (point_count / reference_points);
  return std::min (voxels_per_sample * samples, point_count / min_points_per_voxel);
}

double
singlePrecisionStep (const Points& points)
{
  const auto largest = static_cast<float> (points.origin.cwiseAbs().maxCoeff());
  const float any_above = 2.0f * largest + 1.0f;
  return std::nextafter (largest, any_above) - largest;
}

double
meanPointsPerVoxel (const VoxelGrid& grid)
{
  double points = 0.0;
  for (const Moments& voxel : grid.moments)
    points += voxel.count;
  return points / static_cast<double> (grid.size());
}

VoxelLevels
voxelizeByNoise (const Points& points, double sampling_rate, unsigned threads)
{
  // Chosen by hand; src/doc/constants.csv has F without it.
  constexpr double min_points_per_voxel = 5.0;
  const double size_by_points = voxelSizeFor (
      points, wantedVoxels (points.size(), sampling_rate, min_points_per_voxel));
  if (!(size_by_points > 0.0))
    return {};
  // The edge of a coarse voxel is twice that of a finest one, which is 8 steps or more:
  // chosen by hand, as in smaller voxels the steps look like planes.
  constexpr double min_size_in_steps = 2.0 * 8.0;
  const double min_size = min_size_in_steps * singlePrecisionStep (points);
  VoxelLevels voxels =
      coarsen (voxelize (points, 0.5 * std::max (size_by_points, min_size), threads));
  const double size_by_noise = std::max (voxelSizeByNoise (voxels.coarse), min_size);
  if (size_by_noise < voxels.coarse.voxel_size)
    voxels = coarsen (voxelize (points, 0.5 * size_by_noise, threads));
  return voxels;
}

} // namespace pcl_ops::internal

namespace pcl_ops {

double
voxelSizeFor (const CloudView& points, double wanted_voxels)
{
  internal::Coordinates positions;
  for (std::size_t i = 0; i < points.size; ++i)
    positions.add (points[i][0], points[i][1], points[i][2]);
  return internal::voxelSizeFor (positions, wanted_voxels);
}

} // namespace pcl_ops
