// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "voxels/sparse_points.h"

#include "geometry/noise_ratios.h"
#include "geometry/plane_statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace pcl_ops::internal {

namespace {

// Sparse points are not searched if fewer than one in this many points is sparse.
// Chosen by hand; src/doc/constants.csv has F if they always are.
constexpr std::size_t least_one_in = 100;

// Number of points in a voxel and around it: the neighbors include the voxel itself.
double
pointsAround (const VoxelGrid& grid, std::size_t voxel)
{
  double points = 0.0;
  for (const std::uint32_t neighbor : grid.neighbors[voxel])
    points += grid.moments[neighbor].count;
  return points;
}

// Whether the points of a plane may be a mist: their rms distance to it is above
// other_noise_ratio times the noise of the other planes, and above a quarter of the
// spacing of the points.
bool
isMist (const Moments& moments, double squared_noise)
{
  constexpr double scatter_in_spacings = 0.25; // the least of a mist, chosen by hand
  const std::optional<PlaneFit> fit = fitPlane (moments);
  if (!fit)
    return false;
  const double area =
      squared_width_of_variance * std::sqrt (fit->variances[1] * fit->variances[2]);
  const double max_variance =
      std::max (other_noise_ratio * other_noise_ratio * squared_noise,
                scatter_in_spacings * scatter_in_spacings * area / moments.count);
  return fit->variances[0] > max_variance;
}

// Mean squared distance of all points to their planes [m^2]; infinite without planes,
// so that nothing is a mist.
double
squaredNoise (const std::vector<Moments>& moments_of_planes)
{
  double points = 0.0;
  double squares = 0.0; // sum of the squared distances [m^2]
  for (const Moments& moments : moments_of_planes)
    if (const std::optional<PlaneFit> fit = fitPlane (moments)) {
      points += moments.count;
      squares += moments.count * fit->variances[0];
    }
  return points > 0.0 ? squares / points : std::numeric_limits<double>::infinity();
}

} // namespace

Indices
sparseVoxels (const VoxelGrid& grid, double min_points)
{
  Indices sparse;
  double sparse_points = 0.0;
  double all_points = 0.0;
  for (std::uint32_t voxel = 0; voxel < grid.size(); ++voxel) {
    all_points += grid.moments[voxel].count;
    if (pointsAround (grid, voxel) >= min_points)
      continue;
    sparse.push_back (voxel);
    sparse_points += grid.moments[voxel].count;
  }
  return sparse_points * least_one_in < all_points ? Indices() : sparse;
}

std::vector<OpenPoint>
openPoints (const VoxelGrid& grid, const Indices& voxels, const Labels& labels)
{
  std::vector<OpenPoint> open;
  for (const std::uint32_t voxel : voxels)
    for (const std::uint32_t point : grid.pointsOf (voxel))
      if (labels[point] == no_plane)
        open.push_back ({point, voxel});
  return open;
}

Indices
sparsePoints (const std::vector<OpenPoint>& open, std::size_t cloud_size)
{
  // At most every second point, so that the recursion of detectAmong ends.
  constexpr std::size_t most_one_in = 2;
  const bool are_few = open.size() * least_one_in < cloud_size;
  const bool are_many = open.size() * most_one_in > cloud_size;
  Indices sparse;
  if (are_few || are_many)
    return sparse;
  std::vector<char> is_open (cloud_size, 0);
  for (const auto& [point, voxel] : open)
    is_open[point] = 1;
  for (std::uint32_t point = 0; point < cloud_size; ++point)
    if (is_open[point] != 0)
      sparse.push_back (point);
  return sparse;
}

void
rejectMist (const std::vector<Moments>& dense, unsigned threads, AssignedPoints& sparse)
{
  const double squared_noise = squaredNoise (dense);
  Labels new_labels (sparse.moments.size()); // no_plane for a rejected plane
  for (std::size_t p = 0; p < new_labels.size(); ++p) {
    const bool is_mist = isMist (sparse.moments[p], squared_noise);
    new_labels[p] = is_mist ? no_plane : static_cast<std::int32_t> (p);
    if (is_mist)
      sparse.moments[p] = Moments();
  }
  relabel (sparse.labels, new_labels, threads);
}

} // namespace pcl_ops::internal
