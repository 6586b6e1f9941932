// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "plan_drawing.h"

#include <boost/format.hpp>

#include <Eigen/Geometry>

#include <cli/text.h>
#include <io/output_file.h>

#include <algorithm>
#include <cmath>

namespace pcl_ops::apps {

namespace {

using Json = nlohmann::ordered_json;

// Names of layers in a drawing, and values of the property "layer" in a map.
constexpr const char *wall_layer = "WALL", *opening_layer = "OPENING",
                     *room_layer = "ROOM", *unseen_layer = "UNSEEN",
                     *text_layer = "TEXT";

constexpr double millimeters_in_meter = 1000.0;

/** \brief Returns a point of a plan as a point of its drawing, in which z is 0. */
Eigen::Vector3d
toDrawing (const Eigen::Vector2d& point)
{
  return {point.x(), point.y(), 0.0};
}

/** \brief Returns the height of a room [m]; nothing if its floor or its ceiling is not
 * known. */
std::optional<double>
heightOf (const PlanRoom& room)
{
  if (!room.floor || !room.ceiling)
    return {};
  return *room.ceiling - *room.floor;
}

/** \brief Returns the height [m] of letters that are readable when the whole plan is
 * shown. */
double
readableLetterHeight (const FloorPlan& plan)
{
  // Both are chosen by eye.
  constexpr double min_height = 0.2; // [m]
  constexpr double share_of_diagonal = 0.01;
  Eigen::AlignedBox2d box;
  for (const PlanWall& wall : plan.walls)
    box.extend (wall.from).extend (wall.to);
  if (box.isEmpty())
    return min_height;
  return std::max (min_height, share_of_diagonal * box.diagonal().norm());
}

/** \brief Adds the area of a room and, below it, the height of the room, in letters so
 * small that the texts fit into the room.
 * \param[in] max_letter_height [m] */
void
addTexts (const PlanRoom& room, double max_letter_height, Drawing& drawing)
{
  constexpr double share_of_width = 0.08;          // a line has about ten letters
  const double room_width = std::sqrt (room.area); // as if it were a square
  const double letter_height =
      std::min (max_letter_height, share_of_width * room_width);
  std::vector<std::string> lines = {str (boost::format ("%.2f m\u00b2") % room.area)};
  // Of the outline of a closed room, chosen by hand.
  constexpr double min_enclosed_share = 0.95;
  if (room.enclosed < min_enclosed_share)
    lines.front() += ", open";
  if (const std::optional<double> height = heightOf (room))
    lines.push_back (str (boost::format ("h = %.2f m") % *height));
  constexpr double line_spacing = 1.8; // in heights of letters
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const double lines_below_middle =
        static_cast<double> (i) - 0.5 * static_cast<double> (lines.size() - 1);
    // In a plan y points up, so lines further down have a smaller y.
    const Eigen::Vector2d below_middle (
        0.0, lines_below_middle * line_spacing * letter_height);
    drawing.texts.push_back (
        {text_layer, toDrawing (room.middle - below_middle), lines[i], letter_height});
  }
}

/** \brief Rounds a length [m] to millimeters, as usual in plans. */
double
rounded (double length)
{
  // + 0.0 turns -0 into 0.
  return std::round (millimeters_in_meter * length) / millimeters_in_meter + 0.0;
}

/** \brief Returns the coordinates of a point [m] in the unit of the cloud, as in its
 * reference system.
 * \param[in] meter the length of a meter in the unit of the cloud */
Json
toCoordinates (const Eigen::Vector2d& point, double meter)
{
  return {meter * rounded (point.x()), meter * rounded (point.y())};
}

/** \brief Returns a GeoJSON feature.
 * \param[in] type of the geometry */
Json
toFeature (const char* type, Json coordinates, Json properties)
{
  return {{"type", "Feature"},
          {"geometry", {{"type", type}, {"coordinates", std::move (coordinates)}}},
          {"properties", std::move (properties)}};
}

/** \brief Returns a length [m], rounded to millimeters; null for none. */
Json
lengthOrNull (const std::optional<double>& length)
{
  if (!length)
    return nullptr;
  return rounded (*length);
}

/** \brief Returns a wall as its solid parts.
 * \param[in] number of the wall in the map, its index plus 1
 * \param[in] ids, meter as of \ref planToGeoJson */
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

/** \brief Returns the numbers of rooms, their indices plus 1, as "1 3". */
std::string
numbersOf (const std::vector<std::size_t>& rooms)
{
  std::string numbers;
  for (const std::size_t room : rooms)
    numbers += (numbers.empty() ? "" : " ") + std::to_string (room + 1);
  return numbers;
}

/** \brief Returns the number of a room, its index plus 1; null for no room. */
Json
numberOrNull (const std::optional<std::size_t>& room)
{
  if (!room)
    return nullptr;
  return *room + 1;
}

/** \param[in] wall_number of the wall that has the opening, its index plus 1 */
Json
openingFeature (const PlanOpening& opening, std::size_t wall_number, double meter)
{
  return toFeature (
      "LineString",
      {toCoordinates (opening.from, meter), toCoordinates (opening.to, meter)},
      {{"layer", opening_layer},
       {"wall", wall_number},
       {"length", rounded (opening.width())},
       {"sill", lengthOrNull (opening.sill)},
       {"head", lengthOrNull (opening.head)},
       {"opening", opening.isDoor() ? "door" : "window"},
       {"before", numberOrNull (opening.room_before)},
       {"behind", numberOrNull (opening.room_behind)}});
}

/** \brief Returns the parts of a room's outline without a wall.
 * \param[in] room_number its index plus 1 */
Json
unseenFeature (const PlanRoom& room, std::size_t room_number, double meter)
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
      {{"layer", unseen_layer}, {"room", room_number}, {"length", rounded (length)}});
}

/** \brief Returns a room as the polygon of its outline and holes.
 * \param[in] index of the room in the plan */
Json
roomFeature (const FloorPlan& plan, std::size_t index, double meter)
{
  const PlanRoom& room = plan.rooms[index];
  const auto to_two_decimals = [] (double value) {
    return std::round (100.0 * value) / 100.0;
  };
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
                     {"room", index + 1},
                     {"area", to_two_decimals (room.area)},
                     {"enclosed", to_two_decimals (room.enclosed)},
                     {"floor", lengthOrNull (room.floor)},
                     {"ceiling", lengthOrNull (room.ceiling)},
                     {"height", lengthOrNull (heightOf (room))},
                     {"doors_to", numbersOf (plan.roomsBehindDoorsOf (index))}});
}

} // namespace

Drawing
drawingOf (const FloorPlan& plan)
{
  Drawing drawing;
  // Name, color in CAD, color in browsers, width of lines [mm] as in ISO 128.
  drawing.layers = {{room_layer, CadColor::Green, "#7a9a7a", 0.13},
                    {wall_layer, CadColor::BlackOrWhite, "#000000", 0.5},
                    {opening_layer, CadColor::Blue, "#3060c0", 0.18},
                    {unseen_layer, CadColor::Red, "#c03030", 0.25, LineStyle::Dashed},
                    {text_layer, CadColor::Gray, "#404040", 0.18}};
  const double max_letter_height = readableLetterHeight (plan);
  for (const PlanRoom& room : plan.rooms) {
    for (const PlanarPoints& ring : room.rings) {
      DrawnLine outline{room_layer, {}, true};
      for (const Eigen::Vector2d& corner : ring)
        outline.corners.push_back (toDrawing (corner));
      drawing.lines.push_back (std::move (outline));
    }
    for (const auto& [from, to] : room.unseen)
      drawing.lines.push_back ({unseen_layer, {toDrawing (from), toDrawing (to)}});
    addTexts (room, max_letter_height, drawing);
  }
  for (const PlanWall& wall : plan.walls) {
    for (const auto& [from, to] : wall.solidParts())
      drawing.lines.push_back ({wall_layer, {toDrawing (from), toDrawing (to)}});
    for (const PlanOpening& opening : wall.openings)
      drawing.lines.push_back (
          {opening_layer, {toDrawing (opening.from), toDrawing (opening.to)}});
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
