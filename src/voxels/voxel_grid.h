// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "geometry/points.h"
#include <pcl_ops/plane.h>

#include <cstdint>
#include <vector>

namespace pcl_ops::internal {

/** \brief Integer coordinates of a voxel of a grid. */
struct VoxelKey {
  std::int32_t x = 0, y = 0, z = 0;
};

/** \brief Indices of voxels, one after the other. */
struct VoxelRange {
  const std::uint32_t* first;
  const std::uint32_t* last;

  const std::uint32_t*
  begin () const
  {
    return first;
  }

  const std::uint32_t*
  end () const
  {
    return last;
  }
};

/** \brief For each voxel the occupied ones among its 26 neighbours and, in the middle,
 * itself: most are empty where points are on surfaces. */
class VoxelNeighbours {
public:
  VoxelRange
  operator[] (std::size_t voxel) const
  {
    return {neighbours_.data() + begin_[voxel], neighbours_.data() + begin_[voxel + 1]};
  }

  /** \brief Number of voxels. */
  std::size_t
  size () const
  {
    return begin_.size() - 1;
  }

  void
  reserve (std::size_t voxels)
  {
    constexpr std::size_t usual_neighbours = 12;
    begin_.reserve (voxels + 1);
    neighbours_.reserve (usual_neighbours * voxels);
  }

  /** \brief Appends the next voxel with its \p number neighbours. */
  void
  add (const std::uint32_t* neighbours, std::size_t number)
  {
    neighbours_.insert (neighbours_.end(), neighbours, neighbours + number);
    begin_.push_back (static_cast<std::uint32_t> (neighbours_.size()));
  }

  /** \brief Appends the voxels of another part of the grid. */
  void
  append (const VoxelNeighbours& other)
  {
    const auto before = static_cast<std::uint32_t> (neighbours_.size());
    neighbours_.insert (
        neighbours_.end(), other.neighbours_.begin(), other.neighbours_.end());
    for (std::size_t i = 1; i < other.begin_.size(); ++i)
      begin_.push_back (before + other.begin_[i]);
  }

private:
  std::vector<std::uint32_t> neighbours_;
  std::vector<std::uint32_t> begin_{0};
};

/** \brief The occupied voxels of a uniform grid with the moments of the points in each.
 */
struct VoxelGrid {
  /** \brief Edge of a voxel [m]. */
  double voxel_size = 0.0;
  /** \brief Coordinates of each occupied voxel, in an order that depends on them alone:
   * neighbours in space are near in memory. */
  std::vector<VoxelKey> keys;
  /** \brief Moments of each voxel's points about the zero of their frame. */
  std::vector<Moments> moments;
  VoxelNeighbours neighbours;

  std::size_t
  size () const
  {
    return keys.size();
  }
};

/** \brief A grid with the voxel of each point. */
struct VoxelizedPoints {
  VoxelGrid grid;
  std::vector<std::uint32_t> voxel_of_point;
};

/** \brief Voxel edge at which the points fill about \p wanted_voxels voxels.
 *
 * Counted on a few thousand points in voxels so large that they show all occupied ones,
 * and carried over to small voxels as for surfaces, whose occupied voxels grow with the
 * inverse square of the edge.
 * \return 0 for fewer than two different points */
double
voxelSizeFor (const Coordinates& positions, double wanted_voxels);

/** \brief Sorts points into voxels and adds up their moments in one pass.
 * \param[in] positions finite points; coordinates beyond 2^20 voxels from zero share
 * the outermost voxels \param[in] voxel_size edge of a voxel, above 0 \param[in]
 * threads number of threads; 0: all. The result does not depend on it */
VoxelizedPoints
voxelize (const Coordinates& positions, double voxel_size, unsigned threads);

/** \brief A grid of twice the voxel size whose voxels hold 2 x 2 x 2 voxels each. */
struct CoarserGrid {
  VoxelGrid grid;
  /** \brief For each finer voxel the coarser one that holds it. */
  std::vector<std::uint32_t> voxel_of_finer;
};

CoarserGrid
coarsen (const VoxelGrid& finer, unsigned threads);

} // namespace pcl_ops::internal
