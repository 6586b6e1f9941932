// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "edges.h"

#include "poly_data.h"
#include <detection/plane_json.h>
#include <io/output_file.h>
#include <nlohmann/json.hpp>
#include <numbers/angles.h>

#include <algorithm>

namespace pcl_ops::apps {

namespace {

/** \brief The point of an end of an edge, added unless it is a corner. */
pcl::index_t
pointOf (const Eigen::Vector3d& end, std::size_t corners, PolyData& lines)
{
  const auto last = lines.points.begin() + static_cast<std::ptrdiff_t> (corners);
  // Ends that were drawn to a corner are the corner, to the last digit.
  auto point = std::find (lines.points.begin(), last, end);
  if (point == last)
    point = lines.points.insert (lines.points.end(), end);
  return static_cast<pcl::index_t> (point - lines.points.begin());
}

/** \brief Corners first, then the ends of edges that are at no corner. */
PolyData
toLines (const PlaneEdges& found)
{
  const std::size_t corners = found.corners.size();
  PolyData lines{"edges of planes", Precision::Double, {}, {}, {}, Wires{corners, {}}};
  for (const PlaneCorner& corner : found.corners)
    lines.points.push_back (corner.position);
  for (const PlaneEdge& edge : found.edges) {
    const pcl::index_t from = pointOf (edge.from, corners, lines);
    lines.cells.push_back ({from, pointOf (edge.to, corners, lines)});
    lines.wires->planes.push_back ({edge.planes[0], edge.planes[1]});
  }
  return lines;
}

/** \brief The same with the numbers of planes in place of their positions. */
PlaneEdges
numbered (PlaneEdges found, const std::vector<std::uint32_t>& ids)
{
  const auto number = [&ids] (auto& planes) {
    for (std::size_t& plane : planes)
      plane = ids[plane];
  };
  for (PlaneEdge& edge : found.edges)
    number (edge.planes);
  for (PlaneCorner& corner : found.corners)
    number (corner.planes);
  return found;
}

std::string
toJson (const PlaneEdges& found)
{
  nlohmann::ordered_json json;
  json["edges"] = json["corners"] = nlohmann::ordered_json::array();
  for (const PlaneEdge& edge : found.edges)
    json["edges"].push_back ({{"planes", edge.planes},
                              {"from", toArray (edge.from)},
                              {"to", toArray (edge.to)},
                              {"length", edge.length()},
                              {"angle", toDegrees (edge.angle)}});
  for (const PlaneCorner& corner : found.corners)
    json["corners"].push_back (
        {{"planes", corner.planes}, {"position", toArray (corner.position)}});
  constexpr int indent = 2;
  return json.dump (indent) + "\n";
}

} // namespace

void
saveEdges (const std::string& file,
           const Eigen::Isometry3d& sensor_pose,
           const PlaneEdges& found,
           const std::vector<std::uint32_t>& ids)
{
  const PlaneEdges edges = numbered (found, ids);
  if (extensionOf (file) == ".json")
    return writeTextFile (file, toJson (edges));
  savePolyData (file, sensor_pose, toLines (edges));
}

} // namespace pcl_ops::apps
