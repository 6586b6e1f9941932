// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "edge_drawing.h"

#include <numbers/angles.h>

namespace pcl_ops::apps {

namespace {

using Json = nlohmann::ordered_json;

/** \brief Returns the GeoJSON feature of an edge. */
Json
featureOf (const PlaneEdge& edge)
{
  // One property for each plane, not a list: GDAL's formats have no lists.
  return {
      {"type", "Feature"},
      {"geometry",
       {{"type", "LineString"}, {"coordinates", Json::array ({edge.from, edge.to})}}},
      {"properties",
       {{"plane1", edge.planes[0]},
        {"plane2", edge.planes[1]},
        {"length", edge.length()},
        {"angle", toDegrees (edge.angle)}}}};
}

/** \brief Returns the GeoJSON feature of a corner. */
Json
featureOf (const PlaneCorner& corner)
{
  return {{"type", "Feature"},
          {"geometry", {{"type", "Point"}, {"coordinates", corner.position}}},
          {"properties",
           {{"plane1", corner.planes[0]},
            {"plane2", corner.planes[1]},
            {"plane3", corner.planes[2]}}}};
}

} // namespace

Drawing
drawingOf (const PlaneEdges& edges, double meter)
{
  const char* const layer = "EDGE";
  constexpr double line_width = 0.25; // on paper [mm]
  Drawing drawing;
  drawing.meter = meter;
  drawing.layers = {{layer, CadColor::BlackOrWhite, "#000000", line_width}};
  for (const PlaneEdge& edge : edges.edges)
    drawing.lines.push_back ({layer, {edge.from, edge.to}});
  return drawing;
}

std::string
edgesToGeoJson (const PlaneEdges& edges, const std::string& crs)
{
  std::vector<std::string> features;
  for (const PlaneEdge& edge : edges.edges)
    features.push_back (featureOf (edge).dump());
  for (const PlaneCorner& corner : edges.corners)
    features.push_back (featureOf (corner).dump());
  return featureCollection (features, crs);
}

} // namespace pcl_ops::apps
