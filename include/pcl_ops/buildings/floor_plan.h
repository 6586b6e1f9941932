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

struct FloorPlanParameters {
  /** \brief Where walls are cut, over the lowest floor [m]; for another story add its
   * height. It is above most furniture, below the
   * heads of doors and windows, as in architects' plans. */
  double cut_height = 1.2;
  /** \brief The narrowest gap of a wall that is an opening [m]. */
  double min_opening = 0.4;
  /** \brief The widest one: what is farther apart are two walls [m]. */
  double max_opening = 4.0;
  /** \brief Farthest that an end of a wall is drawn to, or cut off at, another wall
   * [m]. */
  double max_snap = 0.35;
  /** \brief The smallest room [m^2]. */
  double min_room = 1.0;
  /** \brief The length of a meter in the unit of the cloud and of its planes, 1000 of
   * millimeters; all else here and the plan are in meters. */
  double meter = 1.0;
};

/** \brief What is wrong with parameters, as a sentence; empty if nothing is. */
PCL_OPS_EXPORT std::string
validate (const FloorPlanParameters& parameters);

/** \brief A gap of a wall at the height of the cut. */
struct PlanOpening {
  /** \brief Its ends in the frame of the plan [m]. */
  Eigen::Vector2d from = Eigen::Vector2d::Zero();
  Eigen::Vector2d to = Eigen::Vector2d::Zero();
  /** \brief Heights over the floor of what is seen of the wall below and above it [m];
   * nothing where the wall has no points there. */
  std::optional<double> sill;
  std::optional<double> head;
  /** \brief Positions in FloorPlan::rooms of the rooms before and behind the wall:
   * within 0.3 m of either side, or within 0.7 m behind it where its other side was not
   * seen; nothing where there is none. */
  std::optional<std::size_t> room_before;
  std::optional<std::size_t> room_behind;

  double
  width () const
  {
    return (to - from).norm();
  }

  /** \brief Whether one can walk through: no wall was seen below it but for a
   * threshold below 0.25 m. Else it is a window; one whose parapet is hidden is taken
   * for a door. */
  PCL_OPS_EXPORT bool
  isDoor () const;
};

/** \brief One side of a wall, from corner to corner. The room before it is on the left
 * on the way from its first end to its second. */
struct PlanWall {
  /** \brief Its ends in the frame of the plan [m]. */
  Eigen::Vector2d from = Eigen::Vector2d::Zero();
  Eigen::Vector2d to = Eigen::Vector2d::Zero();
  /** \brief To the other side, where that was seen, too [m]. */
  std::optional<double> thickness;
  /** \brief From its first end on. */
  std::vector<PlanOpening> openings;
  /** \brief Positions in the list of planes, ascending. */
  std::vector<std::size_t> planes;

  double
  length () const
  {
    return (to - from).norm();
  }

  /** \brief The parts between the openings: two ends each. */
  PCL_OPS_EXPORT std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>>
  solidParts () const;
};

struct PlanRoom {
  /** \brief The outline counter-clockwise, then holes clockwise. */
  PlanarRings rings;
  /** \brief Of the outline less the holes [m^2]. */
  double area = 0.0;
  /** \brief How much of the outline is walls and their openings, 0.5 to 1: elsewhere
   * the room goes on, or its walls were not seen. What has less is no room. */
  double enclosed = 0.0;
  /** \brief The parts of the outline without a wall that are 5 cm or longer, two ends
   * each, in the frame of the plan [m]. */
  std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>> unseen;
  /** \brief Along up, from zero of the planes' frame [m]; nothing where it was not
   * seen. */
  std::optional<double> floor;
  std::optional<double> ceiling;
  /** \brief A place within, for its name. */
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
};

/** \brief A level cut through a building. */
struct FloorPlan {
  /** \brief From the frame of the planes to that of the plan, in meters: x and y are
   * those of the plan, z is the height. Where up is z, x and y are those of the planes.
   */
  Eigen::Matrix3d to_plan = Eigen::Matrix3d::Identity();
  /** \brief Height of the floor that the cut is over, and of the cut [m]. */
  double floor = 0.0;
  double height = 0.0;
  std::vector<PlanWall> walls;
  /** \brief By falling area; none where there are more than 1000 walls. */
  std::vector<PlanRoom> rooms;

  /** \brief The rooms that doors lead to from a room, ascending, each once: the graph
   * of the rooms.
   * \param[in] room its position in \ref rooms
   * \return empty for a position that is none */
  PCL_OPS_EXPORT std::vector<std::size_t>
  roomsBehindDoorsOf (std::size_t room) const;
};

/** \brief The floor plan of what planes were found, as far as walls were seen.
 *
 * Walls that continue one another become one line each; their points at the height of
 * the cut say where they are and where their openings are, unless something stands
 * before the gap. Ends are drawn to the walls next to them. The lines of all walls
 * divide the plan into cells. Those under a ceiling or over a floor are in rooms, and
 * rooms go on over other cells up to a wall: a minimum cut tells it for all at once
 * (after Ochmann, Vock, Wessel & Klein, *Automatic reconstruction of parametric
 * building models from indoor point clouds*, Computers & Graphics 54, 2016).
 * \param[in] cloud the input cloud the planes were found in
 * \param[in] planes as a detector gives them
 * \param[in] kinds what they are, as \ref planeKinds says
 * \param[in] up against gravity, any length but 0
 * \param[in] parameters ones \ref validate finds nothing wrong with
 * \param[in] shift zero of the cloud's frame in that of the planes [unit of the cloud]
 * \throw std::invalid_argument if there is a problem, an inlier that is no point of the
 * cloud, or not one kind for each plane */
PCL_OPS_EXPORT FloorPlan
findFloorPlan (const CloudView& cloud,
               const std::vector<PlaneSegment>& planes,
               const std::vector<PlaneKind>& kinds,
               const Eigen::Vector3d& up,
               const FloorPlanParameters& parameters = FloorPlanParameters(),
               const Eigen::Vector3d& shift = Eigen::Vector3d::Zero());

} // namespace pcl_ops
