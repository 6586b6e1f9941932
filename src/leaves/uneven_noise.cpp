// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "leaves/uneven_noise.h"

#include <algorithm>
#include <cmath>

namespace pcl_ops::internal {

namespace {

float
lowQuantile (std::vector<float>& values)
{
  // Of fewer the quantile is that of one or two cells.
  constexpr std::size_t min_cells = 8;
  if (values.size() < min_cells)
    return 0.0f;
  // At .4 creases of furniture and roofs count as noise, at .1 far walls do not.
  constexpr double share = 0.28;
  const auto at = values.begin() + static_cast<std::ptrdiff_t> (
                                       share * static_cast<double> (values.size()));
  std::nth_element (values.begin(), at, values.end());
  return *at;
}

} // namespace

UnevenNoise::UnevenNoise (const CurvePoints& points,
                          const std::vector<CellScatter>& cells,
                          int region_level)
: region_level_ (region_level)
{
  const int shift = 3 * region_level;
  std::array<std::vector<float>, top_level + 1> of_level;
  const auto endRegion = [&] (MortonCode code) {
    Region region{code, {}};
    for (int level = 0; level <= region_level; ++level) {
      region.unevenness[level] = lowQuantile (of_level[level]);
      of_level[level].clear();
    }
    regions_.push_back (region);
  };
  MortonCode region_code = 0;
  bool is_in_region = false;
  for (const CellScatter& cell : cells) {
    // Both sides of a thin wall are no noise.
    constexpr double max_noise = 0.2; // of the edge of a cell
    if (cell.level > region_level || !cell.is_wide ||
        cell.noise > max_noise * std::ldexp (points.cell, cell.level))
      continue;
    const MortonCode code = points.code[cell.begin] >> shift;
    if (is_in_region && code != region_code)
      endRegion (region_code);
    region_code = code;
    is_in_region = true;
    of_level[cell.level].push_back (cell.unevenness);
  }
  if (is_in_region)
    endRegion (region_code);
}

float
UnevenNoise::of (MortonCode code, int level) const
{
  const MortonCode wanted = code >> 3 * region_level_;
  const auto region = std::lower_bound (
      regions_.begin(),
      regions_.end(),
      wanted,
      [] (const Region& one, MortonCode other) { return one.code < other; });
  return region != regions_.end() && region->code == wanted ? region->unevenness[level]
                                                            : 0.0f;
}

} // namespace pcl_ops::internal
