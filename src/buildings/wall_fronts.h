// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "grid_square.h"
#include "wall_faces.h"

#include <vector>

namespace pcl_ops::internal::buildings {

/** \brief A point and the square that it is in, of a grid with edges of
 * edge_of_side_square (constants.h). */
struct PointInSquare {
  GridSquare square;
  Eigen::Vector3d point;
};

/** \brief Floors and ceilings beside walls. They show which side of a wall is its front
 * if the viewpoint of the cloud is unknown. In all functions \p front is the horizontal
 * unit vector to the supposed front of a wall, and \p wall are the inliers of the wall,
 * at least one, in the frame of the plan. */
class RoomSides {
public:
  /** \param[in] points_of_floors_and_ceilings lists of points; copied */
  explicit RoomSides (
      const std::vector<const PlanPoints*>& points_of_floors_and_ceilings);

  /** \brief Returns whether floors and ceilings lie behind a wall, and less than half
   * as much of them in front of it, so that the wall faces the wrong way. */
  bool
  areBehind (const Eigen::Vector2d& front, const PlanPoints& wall) const;

  /** \brief Returns whether floors or ceilings go on from one side to the other
   * above the top of \p wall. Then \p wall is furniture: a ceiling ends at a real wall.
   */
  bool
  goOnOver (const Eigen::Vector2d& front, const PlanPoints& wall) const;

  /** \brief Returns whether floors and ceilings end at a wall: hardly any lie behind
   * it, or at most half as much as in front of it. */
  bool
  endAt (const Eigen::Vector2d& front, const PlanPoints& wall) const;

private:
  /** \brief Numbers of samples along a wall with points beside it: in front of the
   * wall, and behind it. There is a sample for each square with points of the wall. */
  struct SamplesBeside {
    std::size_t before = 0, behind = 0;
  };

  /** \brief Counts the samples beside which there are points higher than \p low [m].
   * The distance beside the wall is beside_wall (constants.h). */
  SamplesBeside
  countBeside (const Eigen::Vector2d& front, const PlanPoints& wall, double low) const;

  /** \brief Returns whether a point higher than \p low [m] lies within
   * reach_beside_wall of a position, measured horizontally. */
  bool
  hasPointAt (const Eigen::Vector2d& position, double low) const;

  /** \brief Points of floors and ceilings, sorted by square. */
  std::vector<PointInSquare> points_;
};

} // namespace pcl_ops::internal::buildings
