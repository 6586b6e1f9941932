// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/container/vector.hpp>

#include "cloud/morton_code.h"
#include "cloud/points.h"

#include <cstdint>

namespace pcl_ops::internal {

/** \brief Successive points of a cloud in the same voxel, at most 16. An unordered
 * cloud has about as many runs as points, and they are most of the memory of a
 * detection: three 32-bit words each, the size in bits that no Morton code needs. */
class PointRun {
public:
  static constexpr std::uint32_t max_size = 16;

  PointRun() = default;

  PointRun (MortonCode code, std::uint32_t first, std::uint32_t size)
  : low_ (static_cast<std::uint32_t> (code << 4) | (size - 1))
  , high_ (static_cast<std::uint32_t> (code >> 28))
  , first_ (first)
  {}

  MortonCode
  code () const
  {
    return static_cast<MortonCode> (high_) << 28 | low_ >> 4;
  }

  std::uint32_t
  size () const
  {
    return low_ % 16 + 1;
  }

  /** \brief Index of the first point; \ref end is the index after the last one. */
  std::uint32_t
  first () const
  {
    return first_;
  }

  std::uint32_t
  end () const
  {
    return first_ + size();
  }

private:
  std::uint32_t low_, high_, first_;
};

/** \brief A Boost vector can be sized without writing to its elements. So room for the
 * largest possible number of runs takes no physical memory. */
using PointRuns = boost::container::vector<PointRun>;

/** \brief Returns the points as runs, sorted by the Morton code of their voxel. Runs of
 * a voxel keep the order of the cloud. For points in the order of a scan, this sorts
 * several times fewer runs than points.
 * \param[in] positions finite points; coordinates beyond 2^18 voxels from zero are
 * clamped to the outermost voxels
 * \param[in] voxel_size edge of a voxel [m] */
PointRuns
sortedRuns (const Coordinates& positions, double voxel_size, unsigned threads);

} // namespace pcl_ops::internal
