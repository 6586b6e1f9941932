// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "wall_faces.h"

#include <utility>
#include <vector>

namespace pcl_ops::internal::buildings {

/** \brief Points in order of the squares of a grid from above. */
using SquaredPoints = std::vector<std::pair<std::pair<long, long>, Eigen::Vector3d>>;

/** \brief Where floors and ceilings are, to tell which side of a wall is its front: the
 * points of a cloud do not say so where it was not seen from one known place. */
class RoomSides {
public:
  /** \param[in] level points of floors and ceilings */
  explicit RoomSides (const std::vector<const PlanPoints*>& level);

  /** \brief Whether floors and ceilings end at a wall from behind, and hardly begin
   * before it. */
  bool
  areBehind (const Eigen::Vector2d& front, const PlanPoints& wall) const;

  /** \brief Whether they go on, from one side to the other, over what ends below them:
   * that is furniture, as a wall ends at its ceiling and the ceiling at the wall. */
  bool
  goOnOver (const Eigen::Vector2d& front, const PlanPoints& wall) const;

  /** \brief Whether hardly any of them are behind a wall: nothing goes on there. */
  bool
  endAt (const Eigen::Vector2d& front, const PlanPoints& wall) const;

private:
  /** \brief How many places beside a wall have points above a height: before it, and
   * behind it. */
  std::pair<std::size_t, std::size_t>
  countBeside (const Eigen::Vector2d& front, const PlanPoints& wall, double low) const;

  /** \brief Whether a point above a height is near a place. */
  bool
  hasPointAt (const Eigen::Vector2d& place, double low) const;

  SquaredPoints points_;
};

} // namespace pcl_ops::internal::buildings
