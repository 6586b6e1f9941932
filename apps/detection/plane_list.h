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

/** \brief Writes a vector to JSON as a list of three numbers. */
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

/** \brief The corners of a closed line; the first corner is not repeated at the end. */
using Ring = std::vector<Eigen::Vector3d>;

/** \brief The outline of a part of a plane, then the holes in it. */
using Rings = std::vector<Ring>;

/** \brief All parts of a plane; empty for a plane without area. */
using Polygons = std::vector<Rings>;

class CommandLine;

/** \brief Returns JSON as indented text. */
std::string
jsonText (const nlohmann::ordered_json& json);

/** \brief Returns a GeoJSON FeatureCollection (RFC 7946) with one feature per line.
 * \param[in] features GeoJSON texts, one for each feature
 * \param[in] crs "EPSG:N", the reference system; if empty, the text names none */
std::string
featureCollection (const std::vector<std::string>& features, const std::string& crs);

/** \brief Returns the content of a map file: a GeoPackage for a .gpkg (\ref
 * geoPackageOf), else the GeoJSON text itself.
 * \param[in] file name of the file, for its extension
 * \param[in] layer name of the layer in a GeoPackage */
std::string
mapFor (const std::string& file, const std::string& geo_json, const std::string& layer);

/** \brief Returns the orientation with a name (\ref toString); nothing for other names.
 */
std::optional<Orientation>
orientationCalled (const std::string& name);

/** \brief Returns the kind with a name (\ref toString); nothing for other names. */
std::optional<PlaneKind>
kindCalled (const std::string& name);

/** \brief Reverses normals that point down, except those of vertical planes. This is
 * for surveys, which were not seen from one sensor position.
 * \param[in] up direction against gravity */
void
turnUp (std::vector<PlaneSegment>& planes, const Eigen::Vector3d& up);

/** \brief Turns each normal to the side of the plane on which the scanners stood that
 * measured most of its inliers.
 * \param[in] scans of the cloud, in the frame of the planes and in the order of their
 * points; the first scan begins with point 0. If empty, the normals stay as they are.
 */
void
turnToScanners (std::vector<PlaneSegment>& planes, const std::vector<Scan>& scans);

/** \brief Returns the JSON object of a plane in a list of planes. Keys whose meaning
 * the name does not tell:
 * - "points": the count of the moments, not of the inliers;
 * - "slope": the angle to the horizontal [degree], 0 to 90;
 * - "aspect": the downhill direction (of a vertical plane the direction of its normal),
 *   clockwise from north, the y axis [degree], from 0 up to 360; null for a level
 * plane, or if z is not up;
 * - "height": the coordinate of the centroid along the up axis [unit of the cloud].
 * \param[in] kind as found with all planes of the cloud
 * \param[in] up unit vector against gravity, in the frame of the plane
 * \param[in] parts of the plane besides the one that the hull of the extent
 * surrounds */
nlohmann::ordered_json
planeObject (std::size_t id,
             const PlaneSegment& segment,
             const PlaneExtent& extent,
             PlaneKind kind,
             const Eigen::Vector3d& up = Eigen::Vector3d::UnitZ(),
             const Polygons& parts = {});

/** \brief Reads all parts of a plane from its \ref planeObject: first the one with the
 * hull. Empty if the hull is empty. As a file may have been edited, other parts and
 * holes without corners are left out. */
Polygons
polygonsIn (const nlohmann::ordered_json& plane);

/** \brief Options for writing a list of planes as a map. */
struct MapOptions {
  /** \brief "EPSG:N", the reference system of the coordinates; if empty, the map names
   * none. */
  std::string crs;
  /** \brief Tolerance of the simplification of outlines [unit of the cloud]: a corner
   * that is as near as this to the line between other corners is left out. 0: all
   * corners are kept. */
  double simplify = 0.0;
};

/** \brief Declares --crs and --simplify. */
void
declareMap (CommandLine& line, MapOptions& options);

/** \brief Declares --meter.
 * \param[out] meter length of a meter in the unit of the cloud, for the rules on
 * buildings: 1000 for a cloud in millimeters */
void
declareMeter (CommandLine& line, double& meter);

/** \brief Checks that the options of \ref declareMap have an effect, and that this
 * build can write the maps.
 * \param[in] planes name of the file with the list of planes; may be empty
 * \param[in] maps names of further outputs that may name a reference system
 * \throws UsageError if --crs or --simplify is given but no file has a format for it,
 * or if a file is a GeoPackage and this build has no SQLite */
void
checkMap (const CommandLine& line,
          const std::string& planes,
          const std::vector<std::string>& maps = {});

/** \brief Returns the content of a file with a list of planes, in the format of its
 * extension: .csv, .geojson, .gpkg, else JSON, which has the list unchanged. In the
 * other formats each number of a vector has its own column or property, as GDAL's
 * formats have no lists. The last column of a .csv is the outline.
 * \param[in] file name of the file, for its extension
 * \param[in] list an object whose "planes" is an array of \ref planeObject */
std::string
planesFor (const std::string& file,
           const nlohmann::ordered_json& list,
           const MapOptions& options);

} // namespace pcl_ops::apps
