// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <pcl_ops/buildings/plane_kinds.h>
#include <pcl_ops/cloud_view.h>
#include <pcl_ops/export.h>
#include <pcl_ops/plane.h>
#include <pcl_ops/plane_extent.h>

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace pcl_ops {

/** \brief Parameters of \ref findFloorPlan. Defaults without a reason are chosen by
 * hand. */
struct FloorPlanParameters {
  /** \brief Height over the lowest floor at which walls are cut [m]; for another story
   * add its height. The default is above most furniture and below the heads of doors
   * and windows, as in architects' plans. */
  double cut_height = 1.2;
  /** \brief Smallest width of a gap in a wall that is an opening [m]. What an end of
   * the wall was extended by, to meet another wall, does not count. */
  double min_opening = 0.4;
  /** \brief Largest width of an opening [m]. A wider gap separates two walls. */
  double max_opening = 4.0;
  /** \brief Largest distance by which an end of a wall is extended or cut back to
   * another wall [m]. */
  double max_snap = 0.35;
  /** \brief Smallest area of a room [m^2]. */
  double min_room = 1.0;
  /** \brief The length of a meter in the unit of the cloud and its planes: 1000 if the
   * unit is a millimeter. The other parameters and the plan are in meters. */
  double meter = 1.0;
};

/** \brief Returns the first problem of the parameters; empty if they are valid. */
PCL_OPS_EXPORT std::string
validate (const FloorPlanParameters& parameters);

/** \brief An opening: a gap in a wall at the height of the cut. */
struct PlanOpening {
  /** \brief Its ends in the frame of the plan [m]. */
  Eigen::Vector2d from = Eigen::Vector2d::Zero();
  Eigen::Vector2d to = Eigen::Vector2d::Zero();
  /** \brief Height over the floor of the highest wall point below the cut, in the
   * middle half of the width of the opening [m]; not set if the wall has no points
   * there. */
  std::optional<double> sill;
  /** \brief The same of the lowest wall point above the cut. */
  std::optional<double> head;
  /** \brief Index, into FloorPlan::rooms, of the room before the wall: within 0.3 m of
   * that side. Not set if there is no room. */
  std::optional<std::size_t> room_before;
  /** \brief The same of the room behind the wall: within 0.3 m of the other side of the
   * wall; if that side was not seen, within 0.7 m behind this one. */
  std::optional<std::size_t> room_behind;

  double
  width () const
  {
    return (to - from).norm();
  }

  /** \brief Returns whether the opening is a door: it has no sill, or one below 0.25 m,
   * a threshold. Otherwise it is a window. A window with a hidden parapet counts as a
   * door. */
  PCL_OPS_EXPORT bool
  isDoor () const;
};

/** \brief One side of a wall, from corner to corner. The room before the wall, at its
 * front, is on the left, looking from \ref from to \ref to. */
struct PlanWall {
  /** \brief Its ends in the frame of the plan [m]. */
  Eigen::Vector2d from = Eigen::Vector2d::Zero();
  Eigen::Vector2d to = Eigen::Vector2d::Zero();
  /** \brief Distance to the other side of the wall [m]; not set if that was not seen.
   */
  std::optional<double> thickness;
  /** \brief Openings, in the order from \ref from to \ref to. */
  std::vector<PlanOpening> openings;
  /** \brief Indices of the wall's planes in the list of planes, ascending. */
  std::vector<std::size_t> planes;

  double
  length () const
  {
    return (to - from).norm();
  }

  /** \brief Returns both ends of each part between openings, in the plan [m]. */
  PCL_OPS_EXPORT std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>>
  solidParts () const;
};

/** \brief A room of a plan. */
struct PlanRoom {
  /** \brief The outline counter-clockwise, then holes clockwise, in the frame of the
   * plan [m]. */
  PlanarRings rings;
  /** \brief Area of the outline minus the area of the holes [m^2]. */
  double area = 0.0;
  /** \brief Share of the length of the outline that is on walls and their openings, 0.5
   * to 1. Elsewhere the room continues, or its walls were not seen. Areas with a
   * smaller share are no rooms. */
  double enclosed = 0.0;
  /** \brief Both ends of each part of the outline without a wall, in the frame of the
   * plan [m]. Parts shorter than 5 cm are left out. */
  std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>> unseen;
  /** \brief Height of the floor: its z in the frame of the plan [m]; not set if it was
   * not seen. */
  std::optional<double> floor;
  /** \brief The same of the ceiling. */
  std::optional<double> ceiling;
  /** \brief A position inside the room, for a label, in the frame of the plan [m]. */
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
};

/** \brief A floor plan: a horizontal cut through a building. */
struct FloorPlan {
  /** \brief Rotates from the frame of the planes to the frame of the plan, and scales
   * to meters: x and y of the result are coordinates in the plan, z is the height. Both
   * frames have the same origin. If up is the z axis, their axes are parallel. */
  Eigen::Matrix3d to_plan = Eigen::Matrix3d::Identity();
  /** \brief Height of the floor below the cut: its z in the frame of the plan [m]. */
  double floor = 0.0;
  /** \brief Height of the cut: its z in the frame of the plan [m]. */
  double height = 0.0;
  std::vector<PlanWall> walls;
  /** \brief Rooms by descending area; empty if there are more than 1000 walls. */
  std::vector<PlanRoom> rooms;

  /** \brief Returns the neighbors of a room in the graph of rooms, whose edges are
   * doors.
   * \param[in] room index into \ref rooms
   * \return indices into \ref rooms, ascending, each once; empty if \p room is out of
   * range */
  PCL_OPS_EXPORT std::vector<std::size_t>
  roomsBehindDoorsOf (std::size_t room) const;
};

/** \brief Makes a floor plan from planes and their kinds, as far as walls were seen.
 *
 * Planes of walls that continue each other become one line. The points at the height of
 * the cut tell where the walls and their openings are; a gap hidden by an object is no
 * opening. Ends of walls are moved to adjacent walls. The lines of all walls divide the
 * plan into cells. Cells under a ceiling or over a floor are in rooms, and rooms extend
 * over other cells up to a wall: a minimum cut decides it for all cells at once (after
 * Ochmann, Vock, Wessel & Klein, *Automatic reconstruction of parametric building
 * models from indoor point clouds*, Computers & Graphics 54, 2016).
 *
 * A floor that is 1.9 m or more above that at the cut is of a story above. Parts of
 * walls and ceilings over such a floor, or up to a meter beside it, belong to that
 * story and not to the plan. A hall or a stairwell beside it has walls and a ceiling as
 * high as they were seen. Where there is a story below, walls begin at the floor.
 * \param[in] cloud the input cloud of the detection
 * \param[in] planes the planes that a detector returned
 * \param[in] kinds the kind of each plane, from \ref planeKinds
 * \param[in] up direction against gravity, of any length but 0
 * \param[in] parameters must be valid (\ref validate)
 * \param[in] shift origin of the cloud's frame in the frame of the planes [unit of the
 * cloud]
 * \throw std::invalid_argument if the parameters are wrong, \p up is zero or not
 * finite, \p shift is not finite, the numbers of kinds and planes differ, or an inlier
 * is not an index into the cloud */
PCL_OPS_EXPORT FloorPlan
findFloorPlan (const CloudView& cloud,
               const std::vector<PlaneSegment>& planes,
               const std::vector<PlaneKind>& kinds,
               const Eigen::Vector3d& up,
               const FloorPlanParameters& parameters = FloorPlanParameters(),
               const Eigen::Vector3d& shift = Eigen::Vector3d::Zero());

} // namespace pcl_ops
