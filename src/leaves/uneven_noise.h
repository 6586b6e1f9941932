// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "leaves/cell_scatter.h"

#include <array>
#include <vector>

namespace pcl_ops::internal {

/** \brief By place and size, how far surfaces are from even: the noise that neighboring
 * points share. Cells much smaller than it are facets of the noise, whose normals tell
 * nothing; white noise makes none. */
class UnevenNoise {
public:
  /** \param[in] cells of the points
   * \param[in] region_level cells of this level are the places */
  UnevenNoise (const CurvePoints& points,
               const std::vector<CellScatter>& cells,
               int region_level);

  /** \brief What somewhat more than a quarter of the cells of a level, in the region
   * that a point is in, are less uneven than [m]; 0 where too few tell.
   * \param[in] code of any point of the region */
  float
  of (MortonCode code, int level) const;

private:
  struct Region {
    MortonCode code;
    std::array<float, top_level + 1> unevenness;
  };

  int region_level_;
  std::vector<Region> regions_;
};

} // namespace pcl_ops::internal
