// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/container/vector.hpp>

#include "cloud/morton_code.h"
#include "cloud/points.h"

#include <cstdint>

namespace pcl_ops::internal {

/** \brief Points that follow each other in a cloud and share a voxel; more than 16 are
 * several runs. A cloud without order has as many runs as points, and they are most of
 * the memory of a detection: three words each, the size in bits no code needs. */
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

  /** \brief Its first point, and the one after its last. */
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

/** \brief Boost can make a vector without writing to it: room for as many runs as there
 * may be takes no memory. */
using PointRuns = boost::container::vector<PointRun>;

/** \brief The points as runs, sorted by the Morton code of their voxel; runs of a voxel
 * in the order of the cloud. Where points come in the order of a scan only the runs,
 * several times fewer, have to be sorted.
 * \param[in] positions finite points; coordinates beyond 2^18 voxels from zero share
 * the outermost voxels */
PointRuns
sortedRuns (const Coordinates& positions, double voxel_size, unsigned threads);

} // namespace pcl_ops::internal
