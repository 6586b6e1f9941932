// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "geometry/points.h"
#include "voxels/morton_code.h"

#include <vector>

namespace pcl_ops::internal {

/** \brief Points that follow each other in a cloud and share a voxel. */
struct PointRun {
  MortonCode code;
  std::uint32_t first;
  std::uint32_t size;
};

/** \brief The points as runs, sorted by the Morton code of their voxel; runs of a voxel
 * in the order of the cloud. Where points come in the order of a scan only the runs,
 * some six times fewer, have to be sorted.
 * \param[in] positions finite points; coordinates beyond 2^20 voxels from zero share
 * the outermost voxels
 * \param[in] voxel_size edge of a voxel, above 0
 * \param[in] threads number of threads; 0: all. The result does not depend on it */
std::vector<PointRun>
sortedRuns (const Coordinates& positions, double voxel_size, unsigned threads);

} // namespace pcl_ops::internal
