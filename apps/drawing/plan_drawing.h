// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "drawing.h"
#include <pcl_ops/buildings/floor_plan.h>

#include <cstdint>

namespace pcl_ops::apps {

/** \brief Returns what a plan has as text: the numbers of walls and rooms and the area
 * of all rooms, "12 walls, 3 rooms, 41.2 m2". */
std::string
contentOf (const FloorPlan& plan);

/** \brief Returns a drawing of a plan in meters, on five layers: WALL has the solid
 * parts of walls, OPENING the openings between these parts, ROOM the outlines of rooms,
 * UNSEEN the parts of these outlines without a wall (dashed), and TEXT the area and the
 * height of each room. */
Drawing
drawingOf (const FloorPlan& plan);

/** \brief Returns a plan as a GeoJSON map. Its features are walls (the lines between
 * their openings), openings (lines), rooms (polygons), and the parts of their outlines
 * without a wall (lines). The property "layer" tells which of these a feature is: WALL,
 * OPENING, ROOM or UNSEEN. Properties are in meters, coordinates in the unit of the
 * cloud.
 * \param[in] ids of the planes, by the indices in PlanWall::planes
 * \param[in] crs as of \ref featureCollection
 * \param[in] meter length of a meter in the unit of the cloud */
std::string
planToGeoJson (const FloorPlan& plan,
               const std::vector<std::uint32_t>& ids,
               const std::string& crs,
               double meter);

/** \brief Writes a plan in the format of the file's extension: .dxf, .svg, .geojson or
 * .gpkg. A .dxf and an .svg are in meters.
 * \param[in] title only for an .svg
 * \param[in] ids, crs, meter as of \ref planToGeoJson, only for a .geojson or .gpkg
 * \throws WorkError if the file cannot be written */
void
savePlan (const std::string& file,
          const FloorPlan& plan,
          const std::vector<std::uint32_t>& ids,
          const std::string& title,
          const std::string& crs,
          double meter);

} // namespace pcl_ops::apps
