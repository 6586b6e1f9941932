// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "drawing.h"
#include <pcl_ops/buildings/floor_plan.h>

#include <cstdint>

namespace pcl_ops::apps {

/** \brief Returns the size of a plan as text: "12 walls, 3 rooms, 41.2 m2". */
std::string
contentOf (const FloorPlan& plan);

/** \brief Draws a plan on five layers: WALL has the solid parts of walls, OPENING the
 * gaps between them, ROOM the outlines of rooms, UNSEEN the parts of outlines without a
 * wall (dashed), and TEXT area and height of each room. */
Drawing
drawingOf (const FloorPlan& plan);

/** \brief Returns a plan as a map, a GeoJSON text: walls (lines between their
 * openings), openings (lines), rooms (polygons) and their outlines without a wall
 * (lines). The property "layer" has the kind. Properties are in meters, coordinates in
 * the unit of the cloud.
 * \param[in] ids of the planes, by the indices in PlanWall::planes
 * \param[in] crs "EPSG:N" or empty
 * \param[in] meter the length of a meter in the unit of the cloud */
std::string
planToGeoJson (const FloorPlan& plan,
               const std::vector<std::uint32_t>& ids,
               const std::string& crs,
               double meter);

/** \brief Writes a plan in the format of the file's extension: .dxf, .svg, .geojson or
 * .gpkg. A .dxf and an .svg are in meters.
 * \param[in] title only for an .svg
 * \param[in] ids, crs, meter as of \ref planToGeoJson, only for a .geojson or .gpkg
 * \throws WorkError if it cannot be written */
void
savePlan (const std::string& file,
          const FloorPlan& plan,
          const std::vector<std::uint32_t>& ids,
          const std::string& title,
          const std::string& crs,
          double meter);

} // namespace pcl_ops::apps
