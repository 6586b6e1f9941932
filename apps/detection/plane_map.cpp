// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "plane_map.h"

#include "outlines.h"
#include "plane_json.h"
#include <cli/command_line.h>
#include <cli/errors.h>
#include <io/output_file.h>

#include <algorithm>
#include <cctype>
#include <utility>
#include <vector>

namespace pcl_ops::apps {

namespace {

using PlaneTable = nlohmann::ordered_json;

const std::string prefix_of_crs = "EPSG:";

bool
isCrs (const std::string& text)
{
  constexpr std::size_t most_digits = 7;
  const std::string digits = text.substr (std::min (prefix_of_crs.size(), text.size()));
  return text.compare (0, prefix_of_crs.size(), prefix_of_crs) == 0 &&
         !digits.empty() && digits.size() <= most_digits &&
         std::all_of (digits.begin(), digits.end(), [] (unsigned char digit) {
           return std::isdigit (digit) != 0;
         });
}

/** \brief A plane's columns and their values; lists are taken apart. */
std::vector<std::pair<const char*, PlaneTable>>
columnsOf (const PlaneTable& plane)
{
  const PlaneTable &coefficients = plane.at ("coefficients"),
                   &centroid = plane.at ("centroid"), &normal = plane.at ("normal"),
                   &extent = plane.at ("extent");
  return {{"id", plane.at ("id")},         {"orientation", plane.at ("orientation")},
          {"points", plane.at ("points")}, {"a", coefficients.at (0)},
          {"b", coefficients.at (1)},      {"c", coefficients.at (2)},
          {"d", coefficients.at (3)},      {"centroid_x", centroid.at (0)},
          {"centroid_y", centroid.at (1)}, {"centroid_z", centroid.at (2)},
          {"normal_x", normal.at (0)},     {"normal_y", normal.at (1)},
          {"normal_z", normal.at (2)},     {"rms", plane.at ("rms")},
          {"area", plane.at ("area")},     {"length", extent.at ("length")},
          {"width", extent.at ("width")},  {"slope", plane.at ("slope")},
          {"aspect", plane.at ("aspect")}, {"height", plane.at ("height")}};
}

int
decimalsOf (const PlaneTable& planes)
{
  std::vector<double> widths;
  for (const PlaneTable& plane : planes)
    widths.push_back (plane.at ("extent").at ("width").get<double>());
  return decimalsFor (widths);
}

Polygons
outlineOf (const PlaneTable& plane, const MapOptions& options)
{
  Polygons polygons = polygonsIn (plane);
  for (Rings& rings : polygons)
    rings = seenFromAbove (simplified (std::move (rings), options.simplify));
  return polygons;
}

std::string
toCsv (const PlaneTable& planes, const MapOptions& options)
{
  std::string csv;
  for (const auto& [name, value] : columnsOf (planeObject (0, {}, {}, {})))
    csv += std::string (name) + ",";
  csv += "wkt\n";
  const int decimals = decimalsOf (planes);
  for (const PlaneTable& plane : planes) {
    for (const auto& [name, value] : columnsOf (plane))
      csv += (value.is_string() ? value.get<std::string>()
              : value.is_null() ? ""
                                : value.dump()) +
             ",";
    csv += "\"" + toWkt (outlineOf (plane, options), decimals) + "\"\n";
  }
  return csv;
}

std::string
toGeoJson (const PlaneTable& planes, const MapOptions& options)
{
  std::string text = "{\"type\":\"FeatureCollection\",";
  if (!options.crs.empty())
    text += R"("crs":{"type":"name","properties":{"name":"urn:ogc:def:crs:EPSG::)" +
            options.crs.substr (prefix_of_crs.size()) + "\"}},";
  text += "\"features\":[";
  const int decimals = decimalsOf (planes);
  for (const PlaneTable& plane : planes) {
    PlaneTable properties;
    for (const auto& [name, value] : columnsOf (plane)) {
      const std::string column = name;
      const bool is_normal = column.rfind ("normal_", 0) == 0;
      properties[is_normal ? "n" + column.substr (column.size() - 1) : column] = value;
    }
    text +=
        (&plane == &planes.front() ? "\n" : ",\n") +
        std::string ("{\"type\":\"Feature\",\"id\":") + plane.at ("id").dump() +
        ",\"geometry\":" + toGeoJsonGeometry (outlineOf (plane, options), decimals) +
        ",\"properties\":" + properties.dump() + "}";
  }
  return text + "\n]}\n";
}

} // namespace

void
declareMap (CommandLine& line, MapOptions& options)
{
  line.addValue ("crs",
                 "EPSG:N",
                 "reference system to name in --planes FILE.geojson",
                 [&options] (const std::string& text) {
                   if (!isCrs (text))
                     throw UsageError ("--crs",
                                       "'" + text +
                                           "' is not EPSG:N; give a number, as "
                                           "EPSG:25832");
                   options.crs = text;
                 });
  line.addNumber ("simplify",
                  "M",
                  Range::from (0),
                  options.simplify,
                  "straighten outlines in .csv and .geojson, by M at most (0)");
}

void
checkMap (const CommandLine& line, const std::string& planes)
{
  const std::string extension = extensionOf (planes);
  if (line.isGiven ("crs") && extension != ".geojson")
    throw UsageError ("--crs", "is about --planes FILE.geojson; give one");
  if (line.isGiven ("simplify") && extension != ".geojson" && extension != ".csv")
    throw UsageError ("--simplify",
                      "is about --planes FILE.csv or FILE.geojson; give one");
}

std::string
planesFor (const std::string& file, const PlaneTable& list, const MapOptions& options)
{
  const std::string extension = extensionOf (file);
  if (extension == ".csv")
    return toCsv (list.at ("planes"), options);
  if (extension == ".geojson")
    return toGeoJson (list.at ("planes"), options);
  constexpr int indent = 2;
  return list.dump (indent) + "\n";
}

} // namespace pcl_ops::apps
