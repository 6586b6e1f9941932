// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bounded/surface_separation.h"

#include "bounded/depth_buffer.h"
#include "voxels/voxel_traversal.h"

#include <algorithm>
#include <array>
#include <utility>

namespace pcl_ops::internal {

namespace {

/** \brief Connected voxels of one plane. */
struct Part {
  std::int32_t plane;
  Indices voxels;
};

// The connected parts of all planes with at least a number of voxels, the larger first.
std::vector<Part>
largeParts (const VoxelGrid& grid,
            const BoundedPlanes& planes,
            std::size_t least_voxels)
{
  std::vector<Part> parts;
  Labels unvisited = planes.plane_of_voxel;
  for (std::uint32_t i = 0; i < grid.size(); ++i) {
    const std::int32_t plane = unvisited[i];
    if (plane == no_plane)
      continue;
    Indices voxels = connectedVoxels (grid, i, [&] (std::uint32_t voxel) {
      return unvisited[voxel] == plane &&
             std::exchange (unvisited[voxel], no_plane) == plane;
    });
    if (voxels.size() >= least_voxels)
      parts.push_back ({plane, std::move (voxels)});
  }
  std::stable_sort (parts.begin(), parts.end(), [] (const Part& a, const Part& b) {
    return a.voxels.size() > b.voxels.size();
  });
  return parts;
}

// Some voxels' centroids, evenly spread over the part.
std::vector<Eigen::Vector3d>
someCentroids (const Part& part, const VoxelGrid& grid)
{
  constexpr std::size_t wanted = 64;
  const std::size_t stride = part.voxels.size() / wanted + 1;
  std::vector<Eigen::Vector3d> centroids;
  for (std::size_t i = 0; i < part.voxels.size(); i += stride)
    centroids.push_back (grid.moments[part.voxels[i]].centroid());
  return centroids;
}

struct Gap {
  double squared_width;
  Eigen::Vector3d from, to;
};

// Where two parts come nearest to each other: the narrowest quarter of the gaps
// between.
std::vector<Gap>
narrowestGaps (const Part& first, const Part& second, const VoxelGrid& grid)
{
  const std::vector<Eigen::Vector3d> ends = someCentroids (second, grid);
  std::vector<Gap> gaps;
  for (const Eigen::Vector3d& from : someCentroids (first, grid)) {
    const auto nearest =
        std::min_element (ends.begin(), ends.end(), [&] (const auto& a, const auto& b) {
          return (a - from).squaredNorm() < (b - from).squaredNorm();
        });
    gaps.push_back ({(*nearest - from).squaredNorm(), from, *nearest});
  }
  std::sort (gaps.begin(), gaps.end(), [] (const Gap& a, const Gap& b) {
    return a.squared_width < b.squared_width;
  });
  gaps.resize ((gaps.size() + 3) / 4);
  return gaps;
}

// Whether the sensor looked through between two parts of a plane. What it did not see,
// because something stood in front, may well connect them.
bool
areSeenApart (const Part& first,
              const Part& second,
              const VoxelGrid& grid,
              const DepthBuffer& view)
{
  const double margin = 2.0 * grid.voxel_size;
  constexpr std::array<double, 3> fractions = {0.3, 0.5, 0.7};
  int through = 0, hidden = 0;
  for (const Gap& gap : narrowestGaps (first, second, grid))
    for (const double fraction : fractions)
      switch (view.lookAt (gap.from + fraction * (gap.to - gap.from), margin)) {
      case Sight::Through:
        ++through;
        break;
      case Sight::Hidden:
        ++hidden;
        break;
      default:
        break;
      }
  return through > 2 * hidden;
}

// The plane of the first of the parts before one that it is not seen apart from.
std::int32_t
surfaceOf (std::size_t part,
           const std::vector<Part>& parts,
           const std::vector<std::int32_t>& surface_of,
           const VoxelGrid& grid,
           const DepthBuffer& view)
{
  for (std::size_t other = 0; other < part; ++other)
    if (parts[other].plane == parts[part].plane &&
        !areSeenApart (parts[part], parts[other], grid, view))
      return surface_of[other];
  return no_plane;
}

bool
anyPlaneHasTwo (const std::vector<Part>& parts, std::size_t planes)
{
  std::vector<char> has_one (planes, 0);
  return std::any_of (parts.begin(), parts.end(), [&] (const Part& part) {
    return std::exchange (has_one[static_cast<std::size_t> (part.plane)], 1) != 0;
  });
}

} // namespace

void
separateSurfaces (const VoxelGrid& grid,
                  const Eigen::Vector3d& viewpoint,
                  std::size_t least_voxels,
                  BoundedPlanes& planes)
{
  const std::vector<Part> parts = largeParts (grid, planes, least_voxels);
  const std::size_t number = planes.planes.size();
  if (!anyPlaneHasTwo (parts, number))
    return;
  const DepthBuffer view (grid, viewpoint);
  std::vector<std::int32_t> surface_of;
  std::vector<char> is_taken (number, 0);
  for (std::size_t p = 0; p < parts.size(); ++p) {
    const auto plane = static_cast<std::size_t> (parts[p].plane);
    std::int32_t surface = surfaceOf (p, parts, surface_of, grid, view);
    if (surface == no_plane && std::exchange (is_taken[plane], 1) != 0) {
      surface = static_cast<std::int32_t> (planes.planes.size());
      planes.planes.push_back (planes.planes[plane]);
    }
    surface_of.push_back (surface == no_plane ? parts[p].plane : surface);
    for (const std::uint32_t voxel : parts[p].voxels)
      planes.plane_of_voxel[voxel] = surface_of[p];
  }
  refitPlanes (grid, planes);
}

} // namespace pcl_ops::internal
