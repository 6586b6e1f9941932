// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "drawing.h"
#include <pcl_ops/buildings/floor_plan.h>

#include <cstdint>

namespace pcl_ops::apps {

/** \brief "12 walls, 3 rooms, 41.2 m2". */
std::string
contentOf (const FloorPlan& plan);

/** \brief A plan with layers WALL, OPENING, ROOM, UNSEEN and TEXT: parts of walls,
 * their gaps, outlines of rooms, their parts without a wall (dashed), area and height
 * of each room. */
Drawing
drawingOf (const FloorPlan& plan);

/** \brief A plan as a map: walls (lines between their openings), openings (lines) and
 * rooms (polygons), told apart by the property "layer". Properties are in meters,
 * coordinates in the unit of the cloud.
 * \param[in] ids of the planes
 * \param[in] crs "EPSG:N" or empty
 * \param[in] meter the length of a meter in the unit of the cloud */
std::string
planToGeoJson (const FloorPlan& plan,
               const std::vector<std::uint32_t>& ids,
               const std::string& crs,
               double meter);

/** \brief Writes a plan as the name of the file asks for: .dxf, .svg, .geojson or
 * .gpkg. Drawings are in meters.
 * \throws WorkError if it cannot be written */
void
savePlan (const std::string& file,
          const FloorPlan& plan,
          const std::vector<std::uint32_t>& ids,
          const std::string& title,
          const std::string& crs,
          double meter);

} // namespace pcl_ops::apps
