// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene.h"
#include <pcl_ops/buildings/floor_plan.h>

#include <algorithm>
#include <vector>

using Eigen::Vector2d;
using Eigen::Vector3d;
using namespace pcl_ops;

/** \brief A part of a wall without points. */
struct Opening {
  /** \brief Where it begins and ends along the wall [m]. */
  double begin, end;
  /** \brief Heights of its lower and its upper edge [m]. */
  double sill, head;
};

constexpr double grid_spacing = 5_cm;
constexpr double half_spacing = 0.5 * grid_spacing; // from a rim to its first points

/** \brief Level rectangles and walls. Each is a grid of points 5 cm apart, and a plane
 * with a kind. */
struct Building {
  pcl::PointCloud<pcl::PointXYZ> cloud = {};
  std::vector<PlaneSegment> planes = {};
  std::vector<PlaneKind> kinds = {};

  /** \brief Adds points, and a plane of this kind and normal with all of them as its
   * inliers. */
  Building&
  add (PlaneKind kind, const Vector3d& normal, const std::vector<Vector3d>& points)
  {
    pcl::Indices inliers;
    for (const Vector3d& point : points) {
      inliers.push_back (static_cast<pcl::index_t> (cloud.size()));
      cloud.push_back (toPoint (point));
    }
    planes.push_back (planeOfPoints (cloud, inliers, normal));
    kinds.push_back (kind);
    return *this;
  }

  /** \brief Adds a level rectangle. The normal of a ceiling points down, any other up.
   * \param[in] low,high corners with the lowest and with the highest x and y [m] */
  Building&
  level (PlaneKind kind, double height, const Vector2d& low, const Vector2d& high)
  {
    std::vector<Vector3d> points;
    for (double x = low.x() + half_spacing; x < high.x(); x += grid_spacing)
      for (double y = low.y() + half_spacing; y < high.y(); y += grid_spacing)
        points.emplace_back (x, y, height);
    const double up_or_down = kind == PlaneKind::Ceiling ? -1.0 : 1.0;
    return add (kind, Vector3d (0.0, 0.0, up_or_down), points);
  }

  /** \brief Adds a wall 2.5 m high. Its normal points to the left of the direction from
   * \p from to \p to. */
  Building&
  wall (const Vector2d& from,
        const Vector2d& to,
        const std::vector<Opening>& openings = {})
  {
    const Vector2d along = (to - from).normalized();
    std::vector<Vector3d> points;
    for (double at = half_spacing; at < (to - from).norm(); at += grid_spacing)
      for (double z = half_spacing; z < 2.5; z += grid_spacing) {
        const auto isInOpening = [&] (const Opening& opening) {
          return at > opening.begin && at < opening.end && z > opening.sill &&
                 z < opening.head;
        };
        if (std::none_of (openings.begin(), openings.end(), isInOpening))
          points.emplace_back (from.x() + at * along.x(), from.y() + at * along.y(), z);
      }
    return add (PlaneKind::Wall, {-along.y(), along.x(), 0.0}, points);
  }

  /** \brief The floor plan that is found in the building. */
  FloorPlan
  plan (const FloorPlanParameters& parameters = {}) const
  {
    return findFloorPlan (cloud, planes, kinds, Vector3d::UnitZ(), parameters);
  }
};

/** \brief 0.9 m wide, from the floor to 2.05 m. */
constexpr Opening door = {1.0, 1.9, 0.0, 2.05};
/** \brief 1.5 m wide, 0.9 m to 2.1 m over the floor. */
constexpr Opening window = {1.0, 2.5, 0.9, 2.1};

/** \brief Floor, ceiling and four walls from (0, 0) to (4, 3), the first with a door.
 */
inline Building
roomOf4By3 ()
{
  Building room;
  room.level (PlaneKind::Floor, 0.0, {0, 0}, {4, 3});
  room.level (PlaneKind::Ceiling, 2.5, {0, 0}, {4, 3});
  room.wall ({0, 0}, {4, 0}, {door}).wall ({4, 0}, {4, 3});
  room.wall ({4, 3}, {0, 3}).wall ({0, 3}, {0, 0});
  return room;
}

/** \brief Two rooms of 4 m x 3 m, one from x = 0 to 4 m and one from 4.1 m to 8.1 m.
 * Both sides of the wall between them were seen, and both have the opening. */
inline Building
twoRooms (const Opening& opening = door)
{
  Building apartment;
  for (const double x : {0.0, 4.1}) {
    apartment.level (PlaneKind::Floor, 0.0, {x, 0}, {x + 4, 3});
    apartment.wall ({x, 0}, {x + 4, 0}).wall ({x + 4, 3}, {x, 3});
  }
  // The same opening along the other side, which runs from y = 3 m to y = 0.
  const Opening reversed = {
      3 - opening.end, 3 - opening.begin, opening.sill, opening.head};
  apartment.wall ({8.1, 0}, {8.1, 3}).wall ({0, 3}, {0, 0});
  apartment.wall ({4, 0}, {4, 3}, {opening});
  return apartment.wall ({4.1, 3}, {4.1, 0}, {reversed});
}

/** \brief Number of openings of all walls. */
inline std::size_t
numberOfOpenings (const FloorPlan& plan)
{
  std::size_t number = 0;
  for (const PlanWall& wall : plan.walls)
    number += wall.openings.size();
  return number;
}
