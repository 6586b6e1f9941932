// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plane_map.h"
#include <pcl_ops/orientation.h>
#include <pcl_ops/plane.h>
#include <pcl_ops/plane_extent.h>

#include <cstddef>
#include <optional>

/** \brief Vectors are lists of three numbers. */
template <>
struct nlohmann::adl_serializer<Eigen::Vector3d> {
  template <typename Json>
  static void
  to_json (Json& json, const Eigen::Vector3d& vector)
  {
    json = {vector.x(), vector.y(), vector.z()};
  }

  template <typename Json>
  static void
  from_json (const Json& json, Eigen::Vector3d& vector)
  {
    for (Eigen::Index axis = 0; axis < 3; ++axis)
      json.at (static_cast<std::size_t> (axis)).get_to (vector[axis]);
  }
};

namespace pcl_ops::apps {

std::string
jsonText (const nlohmann::ordered_json& json);

std::optional<Orientation>
orientationCalled (const std::string& name);

struct Attitude {
  /** \brief Angle to the horizontal [degree], 0 to 90. */
  double slope = 0.0;
  /** \brief Where it goes down, clockwise from north, which is y [degree], 0 to 360;
   * nothing for a level plane, and where z is not up. */
  std::optional<double> aspect;
  /** \brief Of the centroid, along the up axis [m]. */
  double height = 0.0;
};

/** \param[in] up unit vector against gravity, in the frame of the plane */
Attitude
attitudeOf (const PlaneSegment& plane, const Eigen::Vector3d& up);

/** \brief Turns the normals of planes up that are not vertical: in a survey, which no
 * single sensor has seen. */
void
turnUp (std::vector<PlaneSegment>& planes, const Eigen::Vector3d& up);

/** \brief A plane as the lists of planes have it; its points are those of its moments.
 * \param[in] parts those beside that of the extent's hull */
nlohmann::ordered_json
planeObject (std::size_t id,
             const PlaneSegment& segment,
             const PlaneExtent& extent,
             const Attitude& attitude,
             const Polygons& parts = {});

/** \brief All parts of such an object. */
Polygons
polygonsIn (const nlohmann::ordered_json& plane);

} // namespace pcl_ops::apps
