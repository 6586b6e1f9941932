// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planes_json.h"

#include "survey_warnings.h"
#include <cli/errors.h>
#include <detection/warning_lines.h>
#include <drawing/plan_drawing.h>
#include <io/inputs.h>
#include <io/output_file.h>
#include <page/page.h>
#include <page/plane_page.h>
#include <picture/image.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <tuple>

namespace fs = std::filesystem;

namespace pcl_ops::apps {

namespace {

using Json = nlohmann::ordered_json;

/** \brief The plane with its normal towards the zero of the frame, where it stays for
 * vertical planes (\ref turnUp). */
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

/** \return the outline of the largest part with the area and the rectangle of all
 * parts, and the outlines of the other parts */
std::pair<PlaneExtent, Polygons>
extentOf (const Plan& plan, const PlaneSegment& segment, const JoinedPlane& plane)
{
  const PlaneFrame frame (segment.centroid, segment.normal);
  std::vector<OutlineEdge> edges = plane.edges;
  if (plane.normal.dot (segment.normal) < 0.0)
    for (OutlineEdge& edge : edges)
      std::swap (edge.from, edge.to);
  const double min_area = std::pow (1.5 * plan.grid.edge, 2);
  const std::vector<PlanarRings> outline = outlineOf (
      edges, frame, outlineUnit (plan.grid.edge), segment.moments.count, min_area);
  PlanarPoints corners;
  for (const PlanarRings& part : outline)
    corners.insert (corners.end(), part.front().begin(), part.front().end());
  PlaneExtent whole = pcl_ops::extentOf ({convexHull (corners, 0.0)}, corners, frame);
  Polygons others;
  whole.area = 0.0;
  for (const PlanarRings& part : outline) {
    PlaneExtent of_part = pcl_ops::extentOf (part, part.front(), frame);
    whole.area += of_part.area;
    if (&part != &outline.front())
      others.push_back (of_part.rings());
    else {
      whole.hull = std::move (of_part.hull);
      whole.holes = std::move (of_part.holes);
    }
  }
  return {std::move (whole), std::move (others)};
}

Json
toObject (const Plan& plan,
          std::size_t id,
          const JoinedPlane& plane,
          const PlaneSegment& segment,
          const PlaneExtent& extent,
          const Polygons& others,
          PlaneKind kind)
{
  Json object =
      planeObject (id, segment, extent, kind, Eigen::Vector3d::UnitZ(), others);
  const Moments& moments = segment.moments;
  object["moments"] = {{"origin", moments.origin},
                       {"count", moments.count},
                       {"sum", moments.sum},
                       {"products", moments.products}};
  object["tiles"] = plane.tiles;
  for (const std::uint32_t input : plane.inputs)
    object["inputs"].push_back (fs::path (plan.inputs[input].file).filename().string());
  return object;
}

/** \brief Removes planes from a list. \return how many, and why */
Dropped
choosePlanes (const PlaneChoice& choice, Json& list)
{
  const Json all = std::move (list.at ("planes"));
  std::vector<PlaneSegment> segments;
  std::vector<PlaneKind> kinds;
  for (const Json& plane : all) {
    segments.push_back (segmentIn (plane));
    const std::string kind = plane.value ("kind", std::string());
    kinds.push_back (kindCalled (kind).value_or (PlaneKind::Other));
  }
  const auto extent_of = [&] (const PlaneSegment& segment) {
    const Json& plane = all[std::size_t (&segment - segments.data())];
    PlaneExtent extent;
    plane.at ("area").get_to (extent.area);
    plane.at ("extent").at ("length").get_to (extent.length);
    plane.at ("extent").at ("width").get_to (extent.width);
    return extent;
  };
  Dropped dropped;
  Json chosen = Json::array();
  for (const std::size_t i :
       chosenOf (choice, segments, kinds, Eigen::Vector3d::UnitZ(), extent_of, dropped))
    chosen.push_back (all[i]);
  if (!dropped.by_option.empty())
    list["dropped"] = toObject (dropped);
  list["planes"] = std::move (chosen);
  return dropped;
}

void
saveImage (const std::string& file, const Json& planes)
{
  std::vector<MapShape> shapes;
  for (const Json& plane : planes) {
    const PlaneSegment segment = segmentIn (plane);
    shapes.push_back ({plane.at ("id").get<std::uint32_t>(),
                       segment.orientation,
                       segment.centroid.z(),
                       {}});
    for (Rings& rings : polygonsIn (plane))
      std::move (rings.begin(), rings.end(), std::back_inserter (shapes.back().rings));
  }
  savePng (file, mapPicture (std::move (shapes)));
}

void
saveView (const std::string& file,
          const std::string& title,
          const Json& list,
          const LabelledPoints& points)
{
  const PlaneSample sample = samplePlanes (list, points, max_points_on_page);
  Json planes = list.at ("planes");
  for (Json& plane : planes)
    for (const char* key : {"moments", "tiles", "inputs"})
      plane.erase (key);
  savePlanePage (file,
                 {title,
                  sample.shifted,
                  sample.planes,
                  std::move (planes),
                  Eigen::Vector3f::UnitZ(),
                  sample.points});
}

std::size_t
countOfKind (PlaneKind kind, const Json& planes)
{
  return static_cast<std::size_t> (
      std::count_if (planes.begin(), planes.end(), [&] (const Json& plane) {
        return plane.value ("kind", std::string()) == toString (kind);
      }));
}

/** \return the plan */
FloorPlan
saveFloorPlan (const PlanesOutput& output,
               const std::string& title,
               const Json& list,
               const LabelledPoints& points)
{
  // Some hundred points per square meter of the walls of a large building.
  constexpr std::size_t enough = 4'000'000;
  const PlaneSample sample = samplePlanes (list, points, enough);
  std::vector<PlaneKind> kinds;
  std::vector<std::uint32_t> ids;
  for (const Json& plane : list.at ("planes")) {
    // Lists of earlier versions have no kinds.
    const std::string kind = plane.value ("kind", std::string());
    kinds.push_back (kindCalled (kind).value_or (PlaneKind::Other));
    ids.push_back (plane.at ("id").get<std::uint32_t>());
  }
  const FloorPlan plan = findFloorPlan (*sample.shifted.cloud,
                                        sample.planes,
                                        kinds,
                                        Eigen::Vector3d::UnitZ(),
                                        output.of_plan,
                                        sample.shifted.shift);
  savePlan (output.floor_plan, plan, ids, title, output.map.crs, output.of_plan.meter);
  return plan;
}

/** \brief The name of the folder that a file is in. */
std::string
folderOf (const std::string& file)
{
  return fs::absolute (file).lexically_normal().parent_path().filename().string();
}

std::string
numberOf (std::size_t planes)
{
  return std::to_string (planes) + (planes == 1 ? " plane" : " planes");
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
  Json json = {{"points", plan.points()},
               {"voxel_size", plan.grid.edge},
               {"tile", plan.grid.edgeOfTile()},
               {"tiles", tiles},
               {"planes", Json::array()}};
  std::vector<PlaneExtent> extents (planes.size());
  std::vector<Polygons> others (planes.size());
  for (std::size_t i = 0; i < planes.size(); ++i)
    std::tie (extents[i], others[i]) = extentOf (plan, segments[i], planes[i]);
  const std::vector<PlaneKind> kinds =
      planeKinds (segments, extents, Eigen::Vector3d::UnitZ(), plan.meter);
  for (std::size_t i = 0; i < planes.size(); ++i)
    json["planes"].push_back (toObject (
        plan, i + 1, planes[i], segments[i], extents[i], others[i], kinds[i]));
  return jsonText (json);
}

PlanesSaid
saveChosenPlanes (const std::string& list_file,
                  const LabelledPoints& points,
                  const PlanesOutput& output)
try {
  Json list = Json::parse (readTextFile (list_file, "planes.json"));
  PlanesSaid said;
  said.warnings = warningsIn (list);
  said.counts = numberOf (list.at ("planes").size());
  if (output.files().empty())
    return said;
  PlanCounts counts;
  counts.wall_planes_found = countOfKind (PlaneKind::Wall, list.at ("planes"));
  counts.has_floor = countOfKind (PlaneKind::Floor, list.at ("planes")) > 0;
  const Dropped dropped = choosePlanes (output.choice, list);
  if (!output.image.empty())
    saveImage (output.image, list.at ("planes"));
  if (!output.view.empty())
    saveView (output.view, folderOf (list_file), list, points);
  if (!output.floor_plan.empty()) {
    const FloorPlan plan = saveFloorPlan (output, folderOf (list_file), list, points);
    counts.walls = plan.walls.size();
    counts.wall_planes_kept = countOfKind (PlaneKind::Wall, list.at ("planes"));
    said.written.push_back (output.floor_plan + ": " + contentOf (plan));
    putWarningOnPlan (counts, said.warnings);
  }
  if (!output.file.empty())
    writeTextFile (output.file, planesFor (output.file, list, output.map));
  const std::string reasons = dropped.reasons();
  said.counts = numberOf (dropped.found) + "; " + output.files().front().second + ": " +
                numberOf (list.at ("planes").size()) +
                (reasons.empty() ? "" : ", dropped " + reasons);
  return said;
}
catch (const Json::exception&) {
  throw WorkError (list_file, "is no list of planes; remove it and run it again");
}

} // namespace pcl_ops::apps
