// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <io/cloud_file.h>
#include <nlohmann/json.hpp>
#include <pcl_ops/buildings/plane_kinds.h>
#include <pcl_ops/orientation.h>
#include <pcl_ops/plane.h>
#include <pcl_ops/plane_extent.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

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

/** \brief Corners of a closed line, the first not repeated. */
using Ring = std::vector<Eigen::Vector3d>;

/** \brief The outline of a plane, then its holes; none where it has no area. */
using Rings = std::vector<Ring>;

using Polygons = std::vector<Rings>;

class CommandLine;

std::string
jsonText (const nlohmann::ordered_json& json);

/** \brief A FeatureCollection of GeoJSON (RFC 7946), one feature a line.
 * \param[in] crs "EPSG:N", the reference system; empty: not named */
std::string
featureCollection (const std::vector<std::string>& features, const std::string& crs);

/** \brief What to write to a .geojson or .gpkg (\ref geoPackageOf). */
std::string
mapFor (const std::string& file, const std::string& geo_json, const std::string& layer);

std::optional<Orientation>
orientationCalled (const std::string& name);

std::optional<PlaneKind>
kindCalled (const std::string& name);

/** \brief Turns normals up, but for those of vertical planes: for surveys, which no
 * single sensor has seen. */
void
turnUp (std::vector<PlaneSegment>& planes, const Eigen::Vector3d& up);

/** \brief Turns each normal to the scanners that most points of the plane are from.
 * \param[in] scans of the cloud that planes are of, in their frame; none: leaves them
 */
void
turnToScanners (std::vector<PlaneSegment>& planes, const std::vector<Scan>& scans);

/** \brief A plane as the lists of planes have it; its points are those of its moments.
 * The slope is the angle to the horizontal [degree], 0 to 90; the aspect where the
 * plane goes down, clockwise from north, which is y [degree], 0 to 360, or null for a
 * level plane, and where z is not up; the height that of the centroid along the up axis
 * [unit of the cloud].
 * \param[in] kind among all planes of the cloud
 * \param[in] up unit vector against gravity, in the frame of the plane
 * \param[in] parts further outlines, beside the extent's hull */
nlohmann::ordered_json
planeObject (std::size_t id,
             const PlaneSegment& segment,
             const PlaneExtent& extent,
             PlaneKind kind,
             const Eigen::Vector3d& up = Eigen::Vector3d::UnitZ(),
             const Polygons& parts = {});

/** \brief All parts of such an object. */
Polygons
polygonsIn (const nlohmann::ordered_json& plane);

/** \brief How a list of planes becomes a map. */
struct MapOptions {
  /** \brief "EPSG:N", the reference system of the coordinates; empty: not named. */
  std::string crs;
  /** \brief How near to a straight line corners are left out [unit of
   * the cloud]. */
  double simplify = 0.0;
};

void
declareMap (CommandLine& line, MapOptions& options);

/** \param[out] meter its length in the unit of the clouds, where rules on buildings
 * need it */
void
declareMeter (CommandLine& line, double& meter);

/** \param[in] maps other files that may name a reference system
 * \throws UsageError if an option was given that has no meaning to files so called */
void
checkMap (const CommandLine& line,
          const std::string& planes,
          const std::vector<std::string>& maps = {});

/** \brief The text of a list of planes as the name of a file asks for: .json as it is;
 * .csv with the outline as the last column; .geojson and .gpkg with numbers as
 * properties, as GDAL's formats have no lists.
 * \param[in] list an object whose "planes" are those of \ref planeObject */
std::string
planesFor (const std::string& file,
           const nlohmann::ordered_json& list,
           const MapOptions& options);

} // namespace pcl_ops::apps
