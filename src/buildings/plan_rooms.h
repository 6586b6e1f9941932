// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plan_walls.h"

#include <vector>

namespace pcl_ops::internal::buildings {

/** \brief What is under a ceiling, a roof or over a floor, from above. */
struct Cover {
  /** \brief Points of planes that cover rooms. */
  PlanPoints points;
  /** \brief Points of floors and of ceilings, to tell their heights. */
  PlanPoints floor, ceiling;
};

/** \brief Rooms by falling area.
 * \param[in] smallest of them [m^2] */
std::vector<PlanRoom>
roomsOf (const std::vector<WallFace>& faces,
         const std::vector<WallSpan>& spans,
         const Cover& cover,
         double smallest);

} // namespace pcl_ops::internal::buildings
