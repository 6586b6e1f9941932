// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "intervals.h"
#include <pcl_ops/plane.h>

#include <cstddef>
#include <map>
#include <vector>

namespace pcl_ops::internal::buildings {

/** \brief Points in the frame of a plan: x, y and height [m]. The plan is a horizontal
 * cut through a building, FloorPlanParameters::cut_height above the lowest floor. */
using PlanPoints = std::vector<Eigen::Vector3d>;

/** \brief A directed line in a plan, along a unit vector; its front is to its left. */
struct PlanLine {
  Eigen::Vector2d origin, along;

  /** \brief Unit vector to the front. */
  Eigen::Vector2d
  normal () const
  {
    return {-along.y(), along.x()};
  }
  /** \brief Position of a point along the line, from its origin [m]. */
  double
  positionOf (const Eigen::Vector2d& point) const
  {
    return along.dot (point - origin);
  }
  /** \brief Signed distance of a point [m]: positive in front of the line, negative
   * behind it. */
  double
  distance (const Eigen::Vector2d& point) const
  {
    return normal().dot (point - origin);
  }
  /** \brief The point at a position along the line [m]. */
  Eigen::Vector2d
  at (double position) const
  {
    return origin + position * along;
  }
};

/** \brief A point of a wall: its position along the line of the face, and its height
 * [m]. */
struct FacePoint {
  double position, height;
};

/** \brief One side of the walls on one line that face the same way. */
struct WallFace {
  PlanLine line; // its front is the front of the face
  /** \brief Intervals of the line that have points at any height, and that have points
   * at the height of the cut. */
  Intervals seen, at_cut;
  /** \brief Intervals of the line behind which door leaves and window panes were seen
   * at the height of the cut; set by \ref withoutRecesses. */
  Intervals leaves = {};
  std::vector<FacePoint> points;
  /** \brief Longest gap between points that may be nothing but their spacing [m]. */
  double longest_spacing = 0.0;
  /** \brief Whether rooms end at the face. If so, the face is a wall even where
   * furniture hides it at the cut; otherwise it may be a lintel over an open passage.
   * \ref faceOf leaves it false. */
  bool ends_rooms = false;
  /** \brief Its planes, at least one. Key: index in the list of planes. Value: the
   * interval of the line from the first to the last point of the plane. */
  std::map<std::size_t, Interval> extent_of_plane;

  std::size_t
  firstPlane () const
  {
    return extent_of_plane.begin()->first;
  }
};

/** \brief Returns the face of one wall plane.
 * \param[in] normal of the plane, in the frame of the plan; points to the front
 * \param[in] points inliers of the plane, at least one, in the frame of the plan
 * \param[in] plane_index index of the plane in the list of planes
 * \param[in] height_of_cut in the frame of the plan [m] */
WallFace
faceOf (const Eigen::Vector3d& normal,
        const PlanPoints& points,
        std::size_t plane_index,
        double height_of_cut);

/** \brief Joins faces that lie on one line and face the same way, unless one is a leaf
 * or pane that the other surrounds. The joined face has the line of the face with most
 * points. Faces are returned in order of their planes. */
std::vector<WallFace>
joinFaces (std::vector<WallFace> faces);

/** \brief Returns the faces without fronts of furniture. A face is such a front if it
 * stands before a wall that faces the same way, and points of this wall were seen above
 * most of the length of the front. */
std::vector<WallFace>
withoutFurniture (const std::vector<WallFace>& faces);

/** \brief Returns the faces without door leaves and window panes. A leaf or pane is set
 * back in a gap of a larger face that faces the same way, its wall. The end of a room
 * between two others is none, although it may lie behind a gap between their walls: the
 * sides of the room come forward from it. Where a leaf is seen at the height of the
 * cut, WallFace::at_cut of the wall gets a gap, even if furniture in front of the gap
 * touches the wall, and WallFace::leaves an interval.
 * \param[in] faces the leaves among them are left out
 * \param[in] upright other faces that may be leaves or panes */
std::vector<WallFace>
withoutRecesses (const std::vector<WallFace>& faces,
                 const std::vector<WallFace>& upright);

} // namespace pcl_ops::internal::buildings
