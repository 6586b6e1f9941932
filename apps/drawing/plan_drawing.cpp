// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "plan_drawing.h"

#include <boost/format.hpp>

#include <Eigen/Geometry>

#include <io/output_file.h>

#include <algorithm>
#include <cmath>

namespace pcl_ops::apps {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char *wall_layer = "WALL", *opening_layer = "OPENING",
                     *room_layer = "ROOM", *unseen_layer = "UNSEEN",
                     *text_layer = "TEXT";

constexpr double millimeters_of_meter = 1000.0;

Eigen::Vector3d
inSpace (const Eigen::Vector2d& place)
{
  return {place.x(), place.y(), 0.0};
}

std::optional<double>
heightOf (const PlanRoom& room)
{
  if (!room.floor || !room.ceiling)
    return {};
  return *room.ceiling - *room.floor;
}

/** \brief Height of texts that are readable when the whole plan is shown [m]. */
double
largestText (const FloorPlan& plan)
{
  constexpr double usual = 0.2;
  constexpr double share = 0.01;
  Eigen::AlignedBox2d box;
  for (const PlanWall& wall : plan.walls)
    box.extend (wall.from).extend (wall.to);
  return box.isEmpty() ? usual : std::max (usual, share * box.diagonal().norm());
}

/** \brief Adds a room's area and, below it, its height, in letters that fit into it.
 * \param[in] largest height of the letters at most [m] */
void
addTexts (const PlanRoom& room, double largest, Drawing& drawing)
{
  constexpr double share_of_width = 0.08;
  const double size = std::min (largest, share_of_width * std::sqrt (room.area));
  std::vector<std::string> lines = {str (boost::format ("%.2f m\u00b2") % room.area)};
  constexpr double closed = 0.95; // share of the outline
  if (room.enclosed < closed)
    lines.front() += ", open";
  if (const std::optional<double> height = heightOf (room))
    lines.push_back (str (boost::format ("h = %.2f m") % *height));
  constexpr double line_spacing = 1.8;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const double down =
        (static_cast<double> (i) - 0.5 * static_cast<double> (lines.size() - 1)) *
        line_spacing * size;
    drawing.texts.push_back ({text_layer,
                              inSpace (room.middle - Eigen::Vector2d (0.0, down)),
                              lines[i],
                              size});
  }
}

/** \brief Rounds to millimeters, as usual in plans; + 0.0 turns -0 into 0. */
double
rounded (double length)
{
  return std::round (millimeters_of_meter * length) / millimeters_of_meter + 0.0;
}

/** \brief Coordinates in the unit of the cloud, as in its reference system. */
Json
toCoordinates (const Eigen::Vector2d& place, double meter)
{
  return {meter * rounded (place.x()), meter * rounded (place.y())};
}

Json
toFeature (const char* type, Json coordinates, Json properties)
{
  return {{"type", "Feature"},
          {"geometry", {{"type", type}, {"coordinates", std::move (coordinates)}}},
          {"properties", std::move (properties)}};
}

Json
lengthOrNull (const std::optional<double>& length)
{
  if (!length)
    return nullptr;
  return rounded (*length);
}

Json
wallFeature (const PlanWall& wall,
             std::size_t number,
             const std::vector<std::uint32_t>& ids,
             double meter)
{
  Json lines = Json::array();
  for (const auto& [from, to] : wall.solidParts())
    lines.push_back ({toCoordinates (from, meter), toCoordinates (to, meter)});
  std::string planes;
  for (const std::size_t plane : wall.planes)
    planes += (planes.empty() ? "" : " ") + std::to_string (ids[plane]);
  return toFeature ("MultiLineString",
                    std::move (lines),
                    {{"layer", wall_layer},
                     {"wall", number},
                     {"length", rounded (wall.length())},
                     {"thickness", lengthOrNull (wall.thickness)},
                     {"planes", planes}});
}

/** \brief The numbers of rooms, their positions plus 1, like "1 3". */
std::string
numbersOf (const std::vector<std::size_t>& rooms)
{
  std::string numbers;
  for (const std::size_t room : rooms)
    numbers += (numbers.empty() ? "" : " ") + std::to_string (room + 1);
  return numbers;
}

/** \brief The number of a room, its position plus 1; null for no room. */
Json
numberOrNull (const std::optional<std::size_t>& room)
{
  if (!room)
    return nullptr;
  return *room + 1;
}

Json
openingFeature (const PlanOpening& opening, std::size_t wall, double meter)
{
  return toFeature (
      "LineString",
      {toCoordinates (opening.from, meter), toCoordinates (opening.to, meter)},
      {{"layer", opening_layer},
       {"wall", wall},
       {"length", rounded (opening.width())},
       {"sill", lengthOrNull (opening.sill)},
       {"head", lengthOrNull (opening.head)},
       {"opening", opening.isDoor() ? "door" : "window"},
       {"before", numberOrNull (opening.room_before)},
       {"behind", numberOrNull (opening.room_behind)}});
}

Json
unseenFeature (const PlanRoom& room, std::size_t number, double meter)
{
  Json lines = Json::array();
  double length = 0.0;
  for (const auto& [from, to] : room.unseen) {
    lines.push_back ({toCoordinates (from, meter), toCoordinates (to, meter)});
    length += (to - from).norm();
  }
  return toFeature (
      "MultiLineString",
      std::move (lines),
      {{"layer", unseen_layer}, {"room", number}, {"length", rounded (length)}});
}

Json
roomFeature (const FloorPlan& plan, std::size_t position, double meter)
{
  const PlanRoom& room = plan.rooms[position];
  constexpr double per_area = 100.0;
  Json rings = Json::array();
  for (const PlanarPoints& ring : room.rings) {
    Json corners = Json::array();
    for (const Eigen::Vector2d& corner : ring)
      corners.push_back (toCoordinates (corner, meter));
    corners.push_back (toCoordinates (ring.front(), meter));
    rings.push_back (std::move (corners));
  }
  return toFeature ("Polygon",
                    std::move (rings),
                    {{"layer", room_layer},
                     {"room", position + 1},
                     {"area", std::round (per_area * room.area) / per_area},
                     {"enclosed", std::round (per_area * room.enclosed) / per_area},
                     {"floor", lengthOrNull (room.floor)},
                     {"ceiling", lengthOrNull (room.ceiling)},
                     {"height", lengthOrNull (heightOf (room))},
                     {"doors_to", numbersOf (plan.roomsBehindDoorsOf (position))}});
}

} // namespace

Drawing
drawingOf (const FloorPlan& plan)
{
  Drawing drawing;
  drawing.layers = {{room_layer, 3, "#7a9a7a", 0.13},
                    {wall_layer, 7, "#000000", 0.5},
                    {opening_layer, 5, "#3060c0", 0.18},
                    {unseen_layer, 1, "#c03030", 0.25, true},
                    {text_layer, 8, "#404040", 0.18}};
  const double largest_text = largestText (plan);
  for (const PlanRoom& room : plan.rooms) {
    for (const PlanarPoints& ring : room.rings) {
      DrawnLine outline{room_layer, {}, true};
      for (const Eigen::Vector2d& corner : ring)
        outline.corners.push_back (inSpace (corner));
      drawing.lines.push_back (std::move (outline));
    }
    for (const auto& [from, to] : room.unseen)
      drawing.lines.push_back ({unseen_layer, {inSpace (from), inSpace (to)}});
    addTexts (room, largest_text, drawing);
  }
  for (const PlanWall& wall : plan.walls) {
    for (const auto& [from, to] : wall.solidParts())
      drawing.lines.push_back ({wall_layer, {inSpace (from), inSpace (to)}});
    for (const PlanOpening& opening : wall.openings)
      drawing.lines.push_back (
          {opening_layer, {inSpace (opening.from), inSpace (opening.to)}});
  }
  return drawing;
}

std::string
planToGeoJson (const FloorPlan& plan,
               const std::vector<std::uint32_t>& ids,
               const std::string& crs,
               double meter)
{
  std::vector<std::string> features;
  for (std::size_t i = 0; i < plan.walls.size(); ++i) {
    features.push_back (wallFeature (plan.walls[i], i + 1, ids, meter).dump());
    for (const PlanOpening& opening : plan.walls[i].openings)
      features.push_back (openingFeature (opening, i + 1, meter).dump());
  }
  for (std::size_t i = 0; i < plan.rooms.size(); ++i)
    features.push_back (roomFeature (plan, i, meter).dump());
  for (std::size_t i = 0; i < plan.rooms.size(); ++i)
    if (!plan.rooms[i].unseen.empty())
      features.push_back (unseenFeature (plan.rooms[i], i + 1, meter).dump());
  return featureCollection (features, crs);
}

std::string
contentOf (const FloorPlan& plan)
{
  const auto counted = [] (std::size_t number, const std::string& noun) {
    return std::to_string (number) + " " + noun + (number == 1 ? "" : "s");
  };
  double area = 0.0;
  for (const PlanRoom& room : plan.rooms)
    area += room.area;
  return counted (plan.walls.size(), "wall") + ", " +
         counted (plan.rooms.size(), "room") +
         (plan.rooms.empty() ? "" : str (boost::format (", %.1f m2") % area));
}

void
savePlan (const std::string& file,
          const FloorPlan& plan,
          const std::vector<std::uint32_t>& ids,
          const std::string& title,
          const std::string& crs,
          double meter)
{
  const std::string extension = extensionOf (file);
  if (extension == ".geojson" || extension == ".gpkg")
    return writeTextFile (file,
                          mapFor (file, planToGeoJson (plan, ids, crs, meter), "plan"));
  const Drawing drawing = drawingOf (plan);
  if (extension == ".svg")
    return writeTextFile (file, toSvg (drawing, title));
  writeTextFile (file, toDxf (drawing));
}

} // namespace pcl_ops::apps
