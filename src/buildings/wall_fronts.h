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

private:
  bool
  has (const Eigen::Vector2d& place) const;

  /** \brief Those with points, sorted. */
  std::vector<std::pair<long, long>> squares_;
};

} // namespace pcl_ops::internal::buildings
