// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene.h"

namespace pcl_ops::simulation {

/** \brief A hole in a wall, in the wall's frame: x along it, z up, y < 0 behind it. */
struct Opening {
  double left, right, bottom, top, depth;
};

/** \brief A rectangle in the wall's plane or, for y < 0, behind it. */
Rectangle
upright (double left, double right, double bottom, double top, double y);

/** \brief Adds the part of a wall around a hole, one surface.
 * \param[in,out] body takes its pieces
 * \param[in] hole its depth does not count
 * \param[in] wall the whole wall, as if it had no hole */
void
addWallAround (Body& body, const Opening& hole, const Rectangle& wall);

/** \brief Adds the back, the sides, the sill and the lintel of a hole. */
void
addRecess (Body& body, const Opening& hole);

} // namespace pcl_ops::simulation
