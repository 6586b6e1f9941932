// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "intervals.h"
#include <pcl_ops/plane.h>

#include <cstddef>
#include <vector>

namespace pcl_ops::internal::buildings {

/** \brief Points in the frame of a plan: x, y, and the height. */
using PlanPoints = std::vector<Eigen::Vector3d>;

/** \brief A line from above, with its front to the left of its direction. */
struct PlanLine {
  Eigen::Vector2d origin, along;

  Eigen::Vector2d
  normal () const
  {
    return {-along.y(), along.x()};
  }
  double
  place (const Eigen::Vector2d& point) const
  {
    return along.dot (point - origin);
  }
  /** \brief How far before it a point is; below 0 behind. */
  double
  distance (const Eigen::Vector2d& point) const
  {
    return normal().dot (point - origin);
  }
  Eigen::Vector2d
  at (double place) const
  {
    return origin + place * along;
  }
};

/** \brief One side of walls that continue one another. */
struct WallFace {
  PlanLine line;
  /** \brief Where there are points at any height, and at that of the cut. */
  Intervals seen, cut;
  /** \brief Points of the wall, as (place, height). */
  std::vector<Eigen::Vector2d> points;
  /** \brief Gaps up to this long are between neighboring points [m]. */
  double spacing = 0.0;
  /** \brief Whether rooms end here: it is a wall, too, where furniture hides it at the
   * cut, and no lintel over an open way. */
  bool ends_rooms = false;
  /** \brief Positions in the list of planes, ascending. */
  std::vector<std::size_t> planes;
};

/** \brief The side of a wall that one plane is.
 * \param[in] normal of the plane, in the frame of the plan
 * \param[in] points its inliers
 * \param[in] height of the cut */
WallFace
faceOf (const Eigen::Vector3d& normal,
        const PlanPoints& points,
        std::size_t plane,
        double height);

/** \brief Faces that lie on one line, and face the same way, as one; the line is that
 * of the larger one. Ascending by their first planes. */
std::vector<WallFace>
joinFaces (std::vector<WallFace> faces);

/** \brief Leaves out fronts of furniture: faces that stand before another one that
 * faces the same way, and is seen above most of them. */
std::vector<WallFace>
withoutFurniture (const std::vector<WallFace>& faces);

/** \brief Leaves out leaves and panes: faces that lie, set back, in the gaps of larger
 * ones that face the same way. Walls have gaps where such ones are seen at the height
 * of the cut, even where furniture before a gap touches the wall.
 * \param[in] upright other faces that may be leaves or panes */
std::vector<WallFace>
withoutRecesses (const std::vector<WallFace>& faces,
                 const std::vector<WallFace>& upright);

} // namespace pcl_ops::internal::buildings
