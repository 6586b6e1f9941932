// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene.h"
#include <pcl_ops/buildings/plane_kinds.h>
#include <pcl_ops/orientation.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

using Eigen::Vector3d;
using namespace pcl_ops;

/** \brief Rectangles as planes whose normals point to a sensor; z is up. */
struct Rectangles {
  /** \brief Position of the sensor that sees rectangles added from now on [m]. */
  Vector3d sensor = {2.0, 1.5, 1.2};
  std::vector<PlaneSegment> planes = {};
  std::vector<PlaneExtent> extents = {};

  /** \brief Adds the rectangle with a corner and two edge vectors from it [m]. */
  Rectangles&
  add (const Vector3d& corner, const Vector3d& first, const Vector3d& second)
  {
    const Surface surface{corner, first, second};
    PlaneSegment plane;
    plane.centroid = surface.center();
    plane.normal = surface.normal();
    if (plane.normal.dot (sensor - plane.centroid) < 0.0)
      plane.normal = -plane.normal;
    plane.orientation =
        orientationOf (plane.normal, Vector3d::UnitZ(), paper_angle_tolerance);
    PlaneExtent extent;
    extent.hull = {corner, corner + first, corner + first + second, corner + second};
    extent.center = surface.center();
    const bool is_first_longer = first.norm() >= second.norm();
    extent.long_axis = (is_first_longer ? first : second).normalized();
    extent.short_axis = plane.normal.cross (extent.long_axis);
    extent.length = std::max (first.norm(), second.norm());
    extent.width = std::min (first.norm(), second.norm());
    extent.area = surface.area();
    planes.push_back (plane);
    extents.push_back (extent);
    return *this;
  }

  /** \brief Adds a level rectangle whose corner of least x and y is (x, y, height).
   * \param[in] width,depth extents along x and along y [m] */
  Rectangles&
  level (double height, double width, double depth, double x = 0.0, double y = 0.0)
  {
    return add ({x, y, height}, {width, 0, 0}, {0, depth, 0});
  }

  /** \brief The name of the kind of each plane.
   * \param[in] viewpoint position of the sensor that planeKinds is told, if any */
  std::vector<std::string>
  kinds (const std::optional<Vector3d>& viewpoint = {},
         const Vector3d& up = Vector3d::UnitZ()) const
  {
    constexpr double meter = 1.0;
    std::vector<std::string> names;
    for (const PlaneKind kind : planeKinds (planes, extents, up, meter, viewpoint))
      names.emplace_back (toString (kind));
    return names;
  }

  /** \brief The same for planeKinds that knows the position of the sensor. */
  std::vector<std::string>
  kindsFromSensor (const Vector3d& up = Vector3d::UnitZ()) const
  {
    return kinds (sensor, up);
  }

  /** \brief The name of the kind of the plane that was added last. */
  std::string
  lastKind () const
  {
    return kinds().back();
  }
};

/** \brief A room of 4 m x 3 m x 2.5 m seen from within: floor, ceiling, four walls, in
 * this order. */
inline Rectangles
shell ()
{
  Rectangles shell;
  shell.level (0.0, 4_m, 3_m).level (2.5, 4_m, 3_m);
  for (const double y : {0.0, 3.0})
    shell.add ({0, y, 0}, {4, 0, 0}, {0, 0, 2.5});
  for (const double x : {0.0, 4.0})
    shell.add ({x, 0, 0}, {0, 3, 0}, {0, 0, 2.5});
  return shell;
}
