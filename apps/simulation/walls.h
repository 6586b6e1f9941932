// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene.h"

namespace pcl_ops::simulation {

/** \brief A rectangle in a wall's frame: x along it, z up, y < 0 behind it [m]. */
struct WallRange {
  double left, right, bottom, top;

  Rectangle
  at (double y) const
  {
    return rectangleAlong (0,
                           2,
                           {0.5 * (left + right), y, 0.5 * (bottom + top)},
                           0.5 * (right - left),
                           0.5 * (top - bottom));
  }
};

/** \brief A wall around a hole, one surface, with the back of the hole, its sides, its
 * sill and its lintel.
 * \param[in,out] body takes its pieces
 * \param[in] wall the whole wall, as if it had no hole
 * \param[in] depth of the hole [m] */
void
addWallAround (Body& body, const Rectangle& wall, const WallRange& hole, double depth);

} // namespace pcl_ops::simulation
