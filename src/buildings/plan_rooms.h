// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plan_walls.h"

#include <vector>

namespace pcl_ops::internal::buildings {

/** \brief Points of the planes that cover rooms, in the frame of the plan. */
struct Cover {
  /** \brief Points of all planes that cover rooms: either of roofs, or of floors,
   * ceilings, tables, slabs and ramps. */
  PlanPoints points;
  /** \brief Points of floors and of ceilings, for the heights of rooms. */
  PlanPoints floor, ceiling;
};

/** \brief Returns the rooms by descending area; empty for no walls or more than
 * max_walls (constants.h) walls.
 * \param[in] spans the walls on the faces
 * \param[in] smallest_area of a room [m^2] */
std::vector<PlanRoom>
roomsOf (const std::vector<WallFace>& faces,
         const std::vector<WallSpan>& spans,
         const Cover& cover,
         double smallest_area);

} // namespace pcl_ops::internal::buildings
