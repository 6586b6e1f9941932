// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "voxels/bounded_assignment.h"

#include "base/parallel.h"
#include "geometry/noise_ratios.h"
#include "voxels/plane_bands.h"

#include <algorithm>
#include <limits>

namespace pcl_ops::internal {

namespace {

// Large, so that there are few pieces: each piece has a list of moments of all planes.
// Chosen by hand; only the last digits of moments depend on it.
constexpr std::size_t voxels_per_piece = 4096;

// The input of the assignment, and the labels that it writes.
struct Assignment {
  const Coordinates& points;
  const VoxelGrid& grid;
  const BoundedPlanes& planes;
  const std::vector<PlaneBand>& bands;
  // With a given threshold each point is tested, even if its voxel fits as a whole.
  bool tests_every_point;
  Labels& labels;

  /** \brief Replaces \p around by the planes of a voxel and its neighbors, each once.
   */
  void
  findPlanesAround (std::size_t voxel, Labels& around) const
  {
    around.clear();
    for (const std::uint32_t neighbor : grid.neighbors[voxel])
      addOnce (planes.plane_of_voxel[neighbor], around);
  }

  /** \brief Whether a voxel goes to a plane as a whole: the rms distance of its points
   * to the plane is below like_noise_ratio (1.5) times the plane's noise, and no
   * threshold asks to test each point. */
  bool
  isWhollyOn (std::int32_t plane, std::size_t voxel) const
  {
    const double max_rms = like_noise_ratio * planes.noise[plane];
    return !tests_every_point &&
           meanSquaredDistance (grid.moments[voxel], planes.planes[plane]) <
               max_rms * max_rms;
  }

  /** \brief Labels the points of a voxel.
   * \param[in] around the planes of the voxel and its neighbors
   * \param[in,out] moments of each plane, to which the points are added */
  void
  assign (std::size_t voxel, const Labels& around, std::vector<Moments>& moments) const
  {
    if (around.size() == 1 && isWhollyOn (around[0], voxel)) {
      for (const std::uint32_t point : grid.pointsOf (voxel))
        labels[point] = around[0];
      moments[around[0]].addAligned (grid.moments[voxel]);
      return;
    }
    for (const std::uint32_t point : grid.pointsOf (voxel)) {
      const std::int32_t plane = likeliestOf (around, bands, points, point);
      labels[point] = plane;
      if (plane != no_plane)
        moments[plane].add (points.x[point], points.y[point], points.z[point]);
    }
  }
};

// The band of each plane: as wide as the smaller of noise_factor times its noise and
// max_distance [m].
std::vector<PlaneBand>
bandsOf (const BoundedPlanes& planes,
         double min_noise,
         double max_distance,
         double noise_factor)
{
  std::vector<PlaneBand> bands;
  for (std::size_t p = 0; p < planes.size(); ++p) {
    // A plane without voxels in this grid has noise 0.
    const double noise = std::max (planes.noise[p], min_noise);
    bands.emplace_back (
        planes.planes[p], noise, std::min (noise_factor * noise, max_distance));
  }
  return bands;
}

} // namespace

void
assignToBoundedPlanes (const Coordinates& points,
                       const VoxelGrid& grid,
                       const BoundedPlanes& planes,
                       std::optional<double> distance_threshold,
                       double noise_factor,
                       unsigned threads,
                       const std::vector<char>& is_left_out,
                       AssignedPoints& assigned)
{
  const double max_distance =
      distance_threshold.value_or (std::numeric_limits<double>::infinity());
  const std::vector<PlaneBand> bands =
      bandsOf (planes, minNoise (grid), max_distance, noise_factor);
  const Assignment assignment{
      points, grid, planes, bands, distance_threshold.has_value(), assigned.labels};
  const std::vector<std::vector<Moments>> moments_of_pieces = parallelPieces (
      threads, grid.size(), voxels_per_piece, [&] (std::size_t begin, std::size_t end) {
        std::vector<Moments> moments (planes.size());
        Labels around;
        for (std::size_t voxel = begin; voxel < end; ++voxel)
          if (is_left_out.empty() || is_left_out[voxel] == 0) {
            assignment.findPlanesAround (voxel, around);
            if (!around.empty())
              assignment.assign (voxel, around, moments);
          }
        return moments;
      });
  assigned.moments.resize (planes.size());
  for (const std::vector<Moments>& moments : moments_of_pieces)
    for (std::size_t p = 0; p < moments.size(); ++p)
      assigned.moments[p].addAligned (moments[p]);
}

} // namespace pcl_ops::internal
