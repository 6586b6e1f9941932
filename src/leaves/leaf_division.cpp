// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "leaves/leaf_division.h"

#include <cmath>

namespace pcl_ops::internal {

namespace {

// Uneven noise over the edge of a cell is the slope that normals of its parts err by.
// Leaves where it is larger hold several times the points: leaves as small as elsewhere
// are facets there (src/doc/decisions.md). Not to divide them at all costs CAD models,
// facades and offices, whose creases look uneven, too.
constexpr float max_even_slope = 0.0045f;
constexpr double points_where_uneven = 5.0;

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
  divide (std::uint32_t begin, std::uint32_t end, int level, std::uint32_t around)
  {
    if (level > sizes.largest_level && !isSparse (end - begin, level, around))
      return divideFurther (begin, end, level);
    const MortonCode code = points.code[begin];
    const auto edge = static_cast<float> (std::ldexp (points.cell, level));
    const float slope = uneven.of (code, level) / edge;
    const double max_points =
        sizes.max_points * (slope > max_even_slope ? points_where_uneven : 1.0);
    if (end - begin <= max_points || level <= sizes.smallest_level)
      leaves.push_back ({cornerOf (code, level), begin, end, level, slope});
    else
      divideFurther (begin, end, level);
  }

  // Alone in leaves of usual sizes sparse points would have no neighbors: where a cell
  // and the one that holds it have few, it is a leaf. A corner that a dense wire cuts
  // is none.
  bool
  isSparse (std::uint32_t number, int level, std::uint32_t around) const
  {
    constexpr std::uint32_t sparse_points = 8;
    constexpr std::uint32_t cells_around = 4; // of a surface
    constexpr int larger_levels = 5;
    return number <= sparse_points && around <= cells_around * sparse_points &&
           level <= sizes.largest_level + larger_levels;
  }

  void
  divideFurther (std::uint32_t begin, std::uint32_t end, int level)
  {
    for (std::uint32_t i = begin; i < end;) {
      const std::uint32_t next = endOfCell (points.code, i, end, level - 1);
      divide (i, next, level - 1, end - begin);
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
  const auto number = static_cast<std::uint32_t> (points.size());
  if (number > 0)
    division.divide (0, number, top_level, number);
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
isUneven (const Leaf& leaf)
{
  return leaf.unevenness > max_even_slope;
}

} // namespace pcl_ops::internal
