// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "leaves/curve_points.h"
#include "leaves/uneven_noise.h"

#include <cstdint>
#include <vector>

namespace pcl_ops::internal {

/** \brief A leaf of the octree: a cell that is not divided, with its points. */
struct Leaf {
  /** \brief Of its lowest corner. */
  MortonCode code = 0;
  /** \brief Numbers of its points. */
  std::uint32_t begin = 0, end = 0;
  /** \brief Its edge is 2^level finest cells. */
  int level = 0;
  /** \brief Uneven noise of its place, at its size, over its edge. */
  float unevenness = 0.0f;
};

/** \brief What leaves a cloud is divided into. */
struct LeafSizes {
  int largest_level = 0, smallest_level = 0;
  /** \brief Leaves of more points are divided. */
  double max_points = 0.0;
};

/** \brief Divides the octree from its root down, by the number of points: leaves are
 * small where points are dense, and larger where noise is uneven, as their parts
 * would be facets of the noise. */
std::vector<Leaf>
divideIntoLeaves (const CurvePoints& points,
                  const LeafSizes& sizes,
                  const UnevenNoise& uneven);

/** \brief Adds the occupied eighths of a leaf to a list. */
void
halveLeaf (const CurvePoints& points, const Leaf& leaf, std::vector<Leaf>& halves);

/** \brief Whether neighboring points err alike in the place of a leaf. */
bool
isUneven (const Leaf& leaf);

} // namespace pcl_ops::internal
