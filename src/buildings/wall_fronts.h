// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "wall_faces.h"

#include <utility>
#include <vector>

namespace pcl_ops::internal::buildings {

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

private:
  using Square = std::pair<long, long>;

  /** \brief How many squares beside a wall have points above a height: before it, and
   * behind it. */
  std::pair<std::size_t, std::size_t>
  countBeside (const Eigen::Vector2d& front, const PlanPoints& wall, double low) const;

  /** \brief Those with points, sorted, with the height of the highest. */
  std::vector<std::pair<Square, double>> squares_;
};

} // namespace pcl_ops::internal::buildings
