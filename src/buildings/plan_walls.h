// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "wall_faces.h"
#include <pcl_ops/buildings/floor_plan.h>

#include <functional>
#include <vector>

namespace pcl_ops::internal::buildings {

/** \brief A function that returns whether something in a gap of a wall, or in front of
 * the gap, hides it at the height of the cut. A hidden gap is no opening. */
using IsHidden = std::function<bool (const PlanLine& line, const Interval& gap)>;

/** \brief One wall from corner to corner, on the line of a face. */
struct WallSpan {
  /** \brief Index of the wall's face in the list of faces. */
  std::size_t face;
  /** \brief Intervals of the line of the face: from the first to the last point of the
   * wall, the whole wall after its ends were moved, and its openings. */
  Interval seen;
  Interval whole;
  Intervals openings;
  /** \brief Whether at most the share min_share_at_cut (constants.h) of its length has
   * points at the cut. */
  bool is_hidden = false;
};

/** \brief Returns the walls on each face, face after face, without openings. An end
 * that is within FloorPlanParameters::max_snap of the line of another face is moved to
 * that line, if the other face has points within max_snap of the crossing, too. Walls
 * no longer than max_snap are left out, and walls that are hidden at the cut unless
 * rooms end at their face. */
std::vector<WallSpan>
spansOf (const std::vector<WallFace>& faces, const FloorPlanParameters& parameters);

/** \brief Adds its openings to each wall that is not hidden: gaps at the height of the
 * cut, as long as openings may be, for which \p is_hidden is false. A gap is an opening
 * in any case if leaves or panes are seen in most of it: they are not before the wall,
 * though less deep behind its front than what is seen through a gap. What an end of the
 * wall was extended by makes no gap long enough: nothing is known of it. */
void
addOpenings (const std::vector<WallFace>& faces,
             const FloorPlanParameters& parameters,
             const IsHidden& is_hidden,
             std::vector<WallSpan>& spans);

/** \brief Returns one wall of the plan for each span.
 * \param[in] floor height of the floor in the frame of the plan [m]
 * \param[in] height_of_cut in the frame of the plan [m] */
std::vector<PlanWall>
toWalls (const std::vector<WallFace>& faces,
         const std::vector<WallSpan>& spans,
         double floor,
         double height_of_cut);

} // namespace pcl_ops::internal::buildings
