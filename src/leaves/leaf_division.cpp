// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "leaves/leaf_division.h"

#include <cmath>

namespace pcl_ops::internal {

namespace {

// Uneven noise over the edge of a cell: a slope that normals of its eighths err by.
constexpr double max_slope_to_divide = 0.02;
constexpr float max_slope_to_halve = 0.04f;

MortonCode
cornerOf (MortonCode code, int level)
{
  return code >> 3 * level << 3 * level;
}

struct Division {
  const CurvePoints& points;
  const LeafSizes& sizes;
  const UnevenNoise& uneven;
  std::vector<Leaf> leaves = {};

  void
  divide (std::uint32_t begin, std::uint32_t end, int level)
  {
    if (level > sizes.largest_level)
      return divideFurther (begin, end, level);
    const MortonCode code = points.code[begin];
    const double slope = slopeAt (code, level);
    constexpr double uneven_factor = 3.3;
    const double max_points =
        sizes.max_points * (slope > max_slope_to_divide ? uneven_factor : 1.0);
    if (end - begin <= max_points || level <= sizes.smallest_level)
      leaves.push_back (
          {cornerOf (code, level), begin, end, level, static_cast<float> (slope)});
    else
      divideFurther (begin, end, level);
  }

  // Uneven noise over the edge of a cell, where it is noise: that of a bent surface
  // grows as fast as the edge.
  double
  slopeAt (MortonCode code, int level) const
  {
    constexpr int larger = 2;
    constexpr double max_growth = 1e9;
    const double slope = uneven.of (code, level) / std::ldexp (points.cell, level);
    const double of_larger =
        uneven.of (code, level + larger) / std::ldexp (points.cell, level + larger);
    return of_larger < max_growth * slope ? slope : 0.0;
  }

  void
  divideFurther (std::uint32_t begin, std::uint32_t end, int level)
  {
    for (std::uint32_t i = begin; i < end;) {
      const std::uint32_t next = endOfCell (points.code, i, end, level - 1);
      divide (i, next, level - 1);
      i = next;
    }
  }
};

} // namespace

std::vector<Leaf>
divideIntoLeaves (const CurvePoints& points,
                  const LeafSizes& sizes,
                  const UnevenNoise& uneven)
{
  Division division{points, sizes, uneven};
  if (points.size() > 0)
    division.divide (0, static_cast<std::uint32_t> (points.size()), top_level);
  return std::move (division.leaves);
}

void
halveLeaf (const CurvePoints& points, const Leaf& leaf, std::vector<Leaf>& halves)
{
  const int level = leaf.level - 1;
  for (std::uint32_t i = leaf.begin; i < leaf.end;) {
    const std::uint32_t next = endOfCell (points.code, i, leaf.end, level);
    halves.push_back (
        {cornerOf (points.code[i], level), i, next, level, leaf.unevenness});
    i = next;
  }
}

bool
isEvenEnoughToHalve (const Leaf& leaf)
{
  return leaf.unevenness < max_slope_to_halve;
}

} // namespace pcl_ops::internal
