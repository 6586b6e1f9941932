// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace pcl_ops::apps {

/** \brief Corners of a closed line, the first not repeated. */
using Ring = std::vector<Eigen::Vector3d>;

/** \brief The outline of a plane, then its holes; none where it has no area. */
using Rings = std::vector<Ring>;

using Polygons = std::vector<Rings>;

/** \brief Turns outlines counter-clockwise and holes clockwise as seen from above, as
 * maps want it; vertical rings stay as they are. */
Rings
seenFromAbove (Rings rings);

/** \brief Leaves out corners that are near a straight line between others (Douglas &
 * Peucker), beginning with one that stays, and moves those left to where lines fitted
 * to the sides meet. Holes that have no area then are left out. \param[in] tolerance
 * how near [m]; 0: all corners stay */
Rings
simplified (Rings rings, double tolerance);

/** \brief How many decimals coordinates are written with: three, or as many as a
 * thousandth of the narrowest plane takes.
 * \param[in] widths of all planes [m]; 0 of one without */
int
decimalsFor (const std::vector<double>& widths);

/** \brief As "POLYGON Z ((x y z, ...), ...)" of OGC 06-103r4, rings closed, or as a
 * MULTIPOLYGON Z where there are several. */
std::string
toWkt (const Polygons& polygons, int decimals);

/** \brief As a geometry of GeoJSON (RFC 7946), rings closed; null for none. */
std::string
toGeoJsonGeometry (const Polygons& polygons, int decimals);

class CommandLine;

struct MapOptions {
  /** \brief "EPSG:N", the reference system of the coordinates; empty: not named. */
  std::string crs;
  /** \brief The tolerance of \ref simplified. */
  double simplify = 0.0;
};

void
declareMap (CommandLine& line, MapOptions& options);

/** \param[in] planes the file of --planes, or what its name ends with
 * \throws UsageError if an option was given that such a file knows nothing of */
void
checkMap (const CommandLine& line, const std::string& planes);

/** \brief The text of a list of planes in the format that the name of a file asks for:
 * .json as it is; .csv with the outline, which maps draw, as the last column; .geojson
 * with numbers as properties, as GDAL's formats have no lists.
 * \param[in] list an object whose "planes" are those of \ref planeObject */
std::string
planesFor (const std::string& file,
           const nlohmann::ordered_json& list,
           const MapOptions& options);

} // namespace pcl_ops::apps
