// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planes_json.h"

#include "outline_rings.h"
#include <detection/plane_json.h>
#include <pcl_ops/plane_extent.h>

#include <cmath>
#include <filesystem>
#include <utility>

namespace fs = std::filesystem;

namespace pcl_ops::apps {

namespace {

/** \brief As one of the library; the normal of a vertical plane is towards the zero of
 * the frame. */
PlaneSegment
segmentOf (const JoinedPlane& plane)
{
  PlaneSegment segment;
  const bool faces_zero = plane.fit.plane.distance (Eigen::Vector3d::Zero()) >= 0.0;
  segment.normal = faces_zero ? plane.fit.plane.normal : -plane.fit.plane.normal;
  const Moments moments = plane.moments.toMoments();
  segment.centroid = moments.centroid();
  segment.moments = moments.about (segment.centroid);
  return segment;
}

/** \brief Where a plane ends: the largest part, with the area of all and the rectangle
 * around them, and the others. */
struct JoinedExtent {
  PlaneExtent extent;
  Polygons parts;
};

JoinedExtent
extentOf (const Plan& plan, const PlaneSegment& segment, const JoinedPlane& plane)
{
  const PlaneFrame frame (segment.centroid, segment.normal);
  std::vector<OutlineEdge> edges = plane.edges;
  if (plane.normal.dot (segment.normal) < 0.0)
    for (OutlineEdge& edge : edges)
      std::swap (edge.from, edge.to);
  const double min_area = std::pow (1.5 * plan.cell, 2);
  const std::vector<PlanarRings> outline = outlineOf (std::move (edges),
                                                      frame,
                                                      outlineUnit (plan.cell),
                                                      segment.moments.count,
                                                      min_area);
  PlanarPoints corners;
  for (const PlanarRings& part : outline)
    corners.insert (corners.end(), part.front().begin(), part.front().end());
  JoinedExtent whole{pcl_ops::extentOf ({convexHull (corners, 0.0)}, corners, frame),
                     {}};
  whole.extent.area = 0.0;
  for (const PlanarRings& part : outline) {
    PlaneExtent of_part = pcl_ops::extentOf (part, part.front(), frame);
    whole.extent.area += of_part.area;
    if (&part != &outline.front())
      whole.parts.push_back (of_part.rings());
    else {
      whole.extent.hull = std::move (of_part.hull);
      whole.extent.holes = std::move (of_part.holes);
    }
  }
  return whole;
}

nlohmann::ordered_json
toObject (const Moments& moments)
{
  nlohmann::ordered_json object;
  object["origin"] = toArray (moments.origin);
  object["count"] = moments.count;
  object["sum"] = toArray (moments.sum);
  object["products"] = moments.products;
  return object;
}

nlohmann::ordered_json
toObject (const Plan& plan,
          std::size_t id,
          const JoinedPlane& plane,
          const PlaneSegment& segment)
{
  const JoinedExtent whole = extentOf (plan, segment, plane);
  nlohmann::ordered_json object =
      planeObject (id,
                   segment,
                   whole.extent,
                   attitudeOf (segment, Eigen::Vector3d::UnitZ()),
                   whole.parts);
  object["moments"] = toObject (segment.moments);
  for (const TileKey& tile : plane.tiles)
    object["tiles"].push_back ({tile.x, tile.y});
  for (const std::uint32_t input : plane.inputs)
    object["inputs"].push_back (fs::path (plan.inputs[input].file).filename().string());
  return object;
}

} // namespace

std::string
toJson (const Plan& plan, std::size_t tiles, const std::vector<JoinedPlane>& planes)
{
  std::vector<PlaneSegment> segments;
  for (const JoinedPlane& plane : planes)
    segments.push_back (segmentOf (plane));
  constexpr double tolerance = paper_angle_tolerance;
  nameOrientations (segments, Eigen::Vector3d::UnitZ(), tolerance);
  turnUp (segments, Eigen::Vector3d::UnitZ());
  nlohmann::ordered_json json;
  json["points"] = plan.points();
  json["cell"] = plan.cell;
  json["tile"] = plan.cell * static_cast<double> (plan.cells_of_tile);
  json["tiles"] = tiles;
  json["planes"] = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < planes.size(); ++i)
    json["planes"].push_back (toObject (plan, i + 1, planes[i], segments[i]));
  constexpr int indent = 2;
  return json.dump (indent) + "\n";
}

} // namespace pcl_ops::apps
