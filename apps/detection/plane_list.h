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

/** \brief Corners of a closed polygon; the first corner is not repeated at the end. */
using Ring = std::vector<Eigen::Vector3d>;

/** \brief The outline of a plane, then its holes; empty for a plane without area. */
using Rings = std::vector<Ring>;

/** \brief The outlines of all parts of a plane. */
using Polygons = std::vector<Rings>;

class CommandLine;

/** \brief Returns JSON as indented text. */
std::string
jsonText (const nlohmann::ordered_json& json);

/** \brief Returns a GeoJSON FeatureCollection (RFC 7946) with one feature per line.
 * \param[in] features GeoJSON texts
 * \param[in] crs "EPSG:N", the reference system; empty: not named */
std::string
featureCollection (const std::vector<std::string>& features, const std::string& crs);

/** \brief Returns the content of a map file: a GeoPackage for a .gpkg (\ref
 * geoPackageOf), else the GeoJSON text itself.
 * \param[in] file name of the file, for its extension
 * \param[in] layer name of the layer in a GeoPackage */
std::string
mapFor (const std::string& file, const std::string& geo_json, const std::string& layer);

/** \brief Returns the orientation of a name; nothing for an unknown name. */
std::optional<Orientation>
orientationCalled (const std::string& name);

/** \brief Returns the kind of a name; nothing for an unknown name. */
std::optional<PlaneKind>
kindCalled (const std::string& name);

/** \brief Turns all normals up, except those of vertical planes. This is for surveys,
 * which were not seen from one sensor position. */
void
turnUp (std::vector<PlaneSegment>& planes, const Eigen::Vector3d& up);

/** \brief Turns each normal to the side where the scanners of most inliers stood.
 * \param[in] scans in the frame of the planes and in the order of their points, the
 * first one from point 0 on; empty: the normals stay as they are */
void
turnToScanners (std::vector<PlaneSegment>& planes, const std::vector<Scan>& scans);

/** \brief Returns the JSON object of a plane in a list of planes. Its "points" is the
 * count of the moments, not of the inliers. "slope" is the angle to the horizontal
 * [degree], 0 to 90. "aspect" is the downhill direction (of a vertical plane the
 * direction of its normal), clockwise from north, the y axis [degree], 0 to 360. It is
 * null for a level plane, or if z is not up. "height" is the height of the centroid
 * along the up axis [unit of the cloud].
 * \param[in] kind as found among all planes of the cloud
 * \param[in] up unit vector against gravity, in the frame of the plane
 * \param[in] parts further outlines, besides the hull of the extent */
nlohmann::ordered_json
planeObject (std::size_t id,
             const PlaneSegment& segment,
             const PlaneExtent& extent,
             PlaneKind kind,
             const Eigen::Vector3d& up = Eigen::Vector3d::UnitZ(),
             const Polygons& parts = {});

/** \brief Reads all outlines of a \ref planeObject; empty if its hull is empty. */
Polygons
polygonsIn (const nlohmann::ordered_json& plane);

/** \brief Options for writing a list of planes as a map. */
struct MapOptions {
  /** \brief "EPSG:N", the reference system of the coordinates; empty: not named. */
  std::string crs;
  /** \brief Tolerance of the simplification of outlines [unit of the cloud]: corners
   * this near to a straight line are left out. 0: keeps all. */
  double simplify = 0.0;
};

/** \brief Declares --crs and --simplify. */
void
declareMap (CommandLine& line, MapOptions& options);

/** \brief Declares --meter.
 * \param[out] meter units of the cloud in one meter, for the rules on buildings: 1000
 * for a cloud in millimeters */
void
declareMeter (CommandLine& line, double& meter);

/** \brief Checks that the options of \ref declareMap have an effect.
 * \param[in] planes file name of the list of planes
 * \param[in] maps further outputs that may name a reference system
 * \throws UsageError if --crs or --simplify is given but no file has a format for it,
 * or if a file is a GeoPackage and this build has no SQLite */
void
checkMap (const CommandLine& line,
          const std::string& planes,
          const std::vector<std::string>& maps = {});

/** \brief Returns a list of planes in the format that the extension of a file asks
 * for. A .json gets the list unchanged. A .csv has the outline as its last column. In
 * .csv, .geojson and .gpkg vectors are split into one number per column or property, as
 * GDAL's formats have no lists.
 * \param[in] list an object whose "planes" is an array of \ref planeObject */
std::string
planesFor (const std::string& file,
           const nlohmann::ordered_json& list,
           const MapOptions& options);

} // namespace pcl_ops::apps
