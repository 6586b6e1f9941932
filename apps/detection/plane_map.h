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

class CommandLine;

struct MapOptions {
  /** \brief "EPSG:N", the reference system of the coordinates; empty: not named. */
  std::string crs;
  /** \brief How near to a straight line corners are left out [m]. */
  double simplify = 0.0;
};

void
declareMap (CommandLine& line, MapOptions& options);

/** \throws UsageError if an option was given that has no meaning to a file so called */
void
checkMap (const CommandLine& line, const std::string& planes);

/** \brief The text of a list of planes as the name of a file asks for: .json as it is;
 * .csv with the outline as the last column; .geojson with numbers as properties, as
 * GDAL's formats have no lists.
 * \param[in] list an object whose "planes" are those of \ref planeObject */
std::string
planesFor (const std::string& file,
           const nlohmann::ordered_json& list,
           const MapOptions& options);

} // namespace pcl_ops::apps
