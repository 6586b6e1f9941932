// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>

#include <string>

namespace pcl_ops::apps {

class CommandLine;

/** \brief How planes are drawn in a .csv or .geojson. */
struct MapOptions {
  /** \brief "EPSG:N", the reference system of the coordinates; empty where not named.
   */
  std::string crs;
  /** \brief Corners of outlines that are so near to a straight line between others are
   * left out [m]; 0: none. */
  double simplify = 0.0;
};

/** \brief Declares --crs and --simplify. */
void
declareMap (CommandLine& line, MapOptions& options);

/** \param[in] planes the file of --planes, or what its name ends with
 * \throws UsageError if an option was given that such a file knows nothing of */
void
checkMap (const CommandLine& line, const std::string& planes);

/** \brief The text of a list of planes in the format that the name of a file asks for.
 *
 * .json: the list as it is. .csv: one line per plane under a line of names, the last of
 * which is `wkt`, its outline: programs that know the columns before it, or all by
 * name, need not know it, and those for maps draw it. .geojson: a feature for each
 * plane, in a line, whose properties are numbers, as GDAL's formats have no lists.
 * \param[in] list an object whose "planes" are those of \ref planeObject */
std::string
planesFor (const std::string& file,
           const nlohmann::ordered_json& list,
           const MapOptions& options);

} // namespace pcl_ops::apps
