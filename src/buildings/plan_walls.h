// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "wall_faces.h"
#include <pcl_ops/buildings/floor_plan.h>

#include <functional>
#include <vector>

namespace pcl_ops::internal::buildings {

/** \brief Whether something stands before a part of a wall, at the height of the cut,
 * so that a gap there is no opening. */
using IsHidden = std::function<bool (const PlanLine& line, const Interval& gap)>;

/** \brief A wall, from corner to corner, on the line of a face. */
struct WallSpan {
  /** \brief Its face, a position in the list of them. */
  std::size_t face;
  Interval whole;
  Intervals openings;
  /** \brief It has next to no points at the height of the cut. */
  bool is_hidden = false;
};

/** \brief The walls of each face, with ends drawn to, or cut off at, the walls they
 * meet there. */
std::vector<WallSpan>
spansOf (const std::vector<WallFace>& faces, const FloorPlanParameters& parameters);

/** \brief Adds to each wall the gaps in it that are openings. */
void
addOpenings (const std::vector<WallFace>& faces,
             const FloorPlanParameters& parameters,
             const IsHidden& is_hidden,
             std::vector<WallSpan>& spans);

/** \brief The walls as a plan has them.
 * \param[in] floor, height of the floor and of the cut */
std::vector<PlanWall>
toWalls (const std::vector<WallFace>& faces,
         const std::vector<WallSpan>& spans,
         double floor,
         double height);

} // namespace pcl_ops::internal::buildings
