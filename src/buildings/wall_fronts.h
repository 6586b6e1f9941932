// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "wall_faces.h"

#include <utility>
#include <vector>

namespace pcl_ops::internal::buildings {

/** \brief Points, each with its square in a horizontal grid, sorted by square. */
using SquaredPoints = std::vector<std::pair<std::pair<long, long>, Eigen::Vector3d>>;

/** \brief Floors and ceilings beside walls. They show which side of a wall is its front
 * if the viewpoint of the cloud is unknown. In all functions \p front is the horizontal
 * unit vector to the supposed front, and \p wall are the inliers of the wall. */
class RoomSides {
public:
  /** \param[in] level points of floors and ceilings */
  explicit RoomSides (const std::vector<const PlanPoints*>& level);

  /** \brief Returns whether floors and ceilings lie behind a wall and hardly any in
   * front of it, so that the wall faces the wrong way. */
  bool
  areBehind (const Eigen::Vector2d& front, const PlanPoints& wall) const;

  /** \brief Returns whether floors or ceilings continue from one side to the other
   * above the top of \p wall. Then it is furniture: a ceiling ends at a wall. */
  bool
  goOnOver (const Eigen::Vector2d& front, const PlanPoints& wall) const;

  /** \brief Returns whether floors and ceilings end at a wall: hardly any lie behind
   * it. */
  bool
  endAt (const Eigen::Vector2d& front, const PlanPoints& wall) const;

private:
  /** \brief Returns at how many places along a wall there are points higher than \p low
   * [m] beside it: in front of the wall, and behind it. */
  std::pair<std::size_t, std::size_t>
  countBeside (const Eigen::Vector2d& front, const PlanPoints& wall, double low) const;

  /** \brief Returns whether a point higher than \p low [m] lies within
   * reach_beside_wall of a place. */
  bool
  hasPointAt (const Eigen::Vector2d& place, double low) const;

  SquaredPoints points_;
};

} // namespace pcl_ops::internal::buildings
