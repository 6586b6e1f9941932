// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/container/vector.hpp>

#include "cloud/morton_code.h"
#include "cloud/points.h"

#include <cstdint>

namespace pcl_ops::internal {

/** \brief Successive points of a cloud in the same voxel, at most 16. An unordered
 * cloud has about as many runs as points, and the runs take most of the memory of a
 * detection. So a run has only three words of 32 bits: the 60 bits of the Morton code
 * together with 4 bits for the size, and the first point. */
class PointRun {
public:
  static constexpr std::uint32_t max_size = 16;

  PointRun() = default;

  PointRun (MortonCode code, std::uint32_t first, std::uint32_t size)
  : low_code_and_size_ (static_cast<std::uint32_t> (code << bits_of_size) | (size - 1))
  , high_code_ (static_cast<std::uint32_t> (code >> bits_of_low_code))
  , first_ (first)
  {}

  MortonCode
  code () const
  {
    return static_cast<MortonCode> (high_code_) << bits_of_low_code |
           low_code_and_size_ >> bits_of_size;
  }

  std::uint32_t
  size () const
  {
    return low_code_and_size_ % max_size + 1;
  }

  /** \brief Index of the first point in the cloud; \ref end is the index after the last
   * one. */
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
  static constexpr int bits_of_size = 4;
  static constexpr int bits_of_low_code = 32 - bits_of_size;

  std::uint32_t low_code_and_size_, high_code_, first_;
};

/** \brief A Boost vector can be sized without writing to its elements. So room for the
 * largest possible number of runs takes no physical memory. */
using PointRuns = boost::container::vector<PointRun>;

/** \brief Returns the points as runs, sorted by the Morton codes of their voxels. Runs
 * of one voxel keep the order of the cloud. A cloud in the order of its scan has
 * several times fewer runs than points, so that sorting takes less time.
 * \param[in] positions finite points; coordinates beyond 2^18 voxels from zero are
 * clamped to the outermost voxels
 * \param[in] voxel_size edge of a voxel [m]
 * \param[in] threads largest number of threads; 0: one for each processor */
PointRuns
sortedRuns (const Coordinates& positions, double voxel_size, unsigned threads);

} // namespace pcl_ops::internal
