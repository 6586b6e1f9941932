// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud/voxel_grid.h"

#include "base/parallel.h"
#include "cloud/sorted_points.h"

#include <memory>
#include <utility>

namespace pcl_ops::internal {

namespace {

// Returns the moments of the points of the runs begin .. end - 1, and writes the
// indices of these points from order on.
Moments
momentsOfRuns (const Coordinates& positions,
               const PointRun* begin,
               const PointRun* end,
               std::uint32_t* order)
{
  Moments moments;
  for (const PointRun* run = begin; run != end; ++run)
    for (std::uint32_t i = run->first(); i < run->end(); ++i) {
      moments.add (positions.x[i], positions.y[i], positions.z[i]);
      *order++ = i;
    }
  return moments;
}

/** \brief Makes a voxel of the runs with the same code: sets VoxelGrid::codes and
 * VoxelGrid::first_point.
 * \return the index of the first run of each voxel, then the number of runs */
Indices
addVoxels (const PointRuns& runs, VoxelGrid& grid)
{
  Indices first_run;
  std::uint32_t points_so_far = 0;
  for (std::size_t run = 0; run < runs.size(); ++run) {
    if (run == 0 || runs[run].code() != runs[run - 1].code()) {
      first_run.push_back (static_cast<std::uint32_t> (run));
      grid.codes.push_back (runs[run].code());
      grid.first_point.push_back (points_so_far);
    }
    points_so_far += runs[run].size();
  }
  first_run.push_back (static_cast<std::uint32_t> (runs.size()));
  return first_run;
}

} // namespace

VoxelGrid
voxelize (const Coordinates& positions, double voxel_size, unsigned threads)
{
  const PointRuns runs = sortedRuns (positions, voxel_size, threads);
  VoxelGrid grid;
  grid.voxel_size = voxel_size;
  const Indices first_run = addVoxels (runs, grid);
  grid.moments.resize (grid.size());
  const auto order = std::make_shared<Indices> (positions.size());
  forEach (threads, grid.size(), [&] (std::size_t voxel) {
    grid.moments[voxel] = momentsOfRuns (positions,
                                         runs.data() + first_run[voxel],
                                         runs.data() + first_run[voxel + 1],
                                         order->data() + grid.first_point[voxel]);
  });
  grid.order = order;
  return grid;
}

void
connect (VoxelGrid& grid, unsigned threads)
{
  ConnectedVoxels connected_voxels = connected (grid.codes, threads);
  grid.neighbors = std::move (connected_voxels.neighbors);
  grid.larger = std::move (connected_voxels.larger);
}

std::vector<Moments>
momentsOf (const std::vector<Moments>& moments, const LargerVoxels& larger)
{
  std::vector<Moments> sums (larger.codes.size());
  for (std::size_t i = 0; i < moments.size(); ++i)
    sums[larger.holding[i]].addAligned (moments[i]);
  return sums;
}

Indices
voxelsOfPoints (const VoxelGrid& grid)
{
  Indices voxels (grid.order->size());
  for (std::size_t voxel = 0; voxel < grid.size(); ++voxel)
    for (const std::uint32_t point : grid.pointsOf (voxel))
      voxels[point] = static_cast<std::uint32_t> (voxel);
  return voxels;
}

VoxelLevels
coarsen (VoxelGrid finest)
{
  LargerVoxels larger = largerVoxels (finest.codes);
  VoxelLevels levels;
  VoxelGrid& coarse = levels.coarse;
  coarse.voxel_size = 2.0 * finest.voxel_size;
  coarse.order = finest.order;
  coarse.moments = momentsOf (finest.moments, larger);
  for (std::size_t i = 0; i < finest.size(); ++i) {
    const bool is_first_of_coarse = larger.holding[i] == coarse.first_point.size();
    if (is_first_of_coarse)
      coarse.first_point.push_back (finest.first_point[i]);
  }
  coarse.codes = std::move (larger.codes);
  levels.coarse_of_finest = std::move (larger.holding);
  levels.finest = std::move (finest);
  return levels;
}

} // namespace pcl_ops::internal
