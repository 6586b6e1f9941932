// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "geometry/points.h"
#include "voxels/morton_code.h"

#include <cstddef>
#include <cstdint>
#include <memory>

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

/** \brief Some runs. */
class PointRuns {
public:
  PointRuns() = default;

  /** \param[in] most runs there is room for; what is not written takes no memory */
  explicit PointRuns (std::size_t most) : runs_ (new PointRun[most]) {}

  std::size_t
  size () const
  {
    return size_;
  }

  void
  resize (std::size_t size)
  {
    size_ = size;
  }

  PointRun*
  begin () const
  {
    return runs_.get();
  }

  PointRun*
  end () const
  {
    return runs_.get() + size_;
  }

  const PointRun&
  operator[] (std::size_t run) const
  {
    return runs_[run];
  }

private:
  std::unique_ptr<PointRun[]> runs_;
  std::size_t size_ = 0;
};

/** \brief The points as runs, sorted by the Morton code of their voxel; runs of a voxel
 * in the order of the cloud. Where points come in the order of a scan only the runs,
 * several times fewer, have to be sorted.
 * \param[in] positions finite points; coordinates beyond 2^18 voxels from zero share
 * the outermost voxels
 * \param[in] voxel_size edge of a voxel, above 0
 * \param[in] threads number of threads; 0: all. The result does not depend on it */
PointRuns
sortedRuns (const Coordinates& positions, double voxel_size, unsigned threads);

} // namespace pcl_ops::internal
