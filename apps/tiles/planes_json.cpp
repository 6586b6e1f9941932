// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planes_json.h"

#include "plane_outline.h"
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

namespace fs = std::filesystem;

namespace pcl_ops::apps {

namespace {

using Json = nlohmann::ordered_json;

/** \brief Returns the plane with its normal towards zero of the frame. In \ref toJson
 * turnUp then turns normals of planes that are not vertical. */
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

/** \brief The extent of a plane that may have several parts. */
struct PartedExtent {
  /** \brief Area and rectangle of all parts; hull and holes of the largest part. */
  PlaneExtent extent;
  /** \brief Outlines of the other parts. */
  Polygons other_parts;
};

/** \brief Returns the extent of a joined plane.
 * \param[in] segment the same plane, perhaps with the opposite normal: from the side
 * that it points to, the hull is counter-clockwise */
PartedExtent
extentOf (const Plan& plan, const PlaneSegment& segment, const JoinedPlane& plane)
{
  const PlaneFrame frame (segment.centroid, segment.normal);
  std::vector<OutlineEdge> edges = plane.edges;
  if (plane.normal.dot (segment.normal) < 0.0)
    for (OutlineEdge& edge : edges)
      std::swap (edge.from, edge.to);
  // Chosen by hand: parts and holes with a smaller area than a square of this width are
  // left out.
  constexpr double min_width_in_cells = 1.5;
  const double min_area = std::pow (min_width_in_cells * plan.grid.edge, 2);
  const std::vector<PlanarRings> outline = outlineOf (
      edges, frame, outlineUnit (plan.grid.edge), segment.moments.count, min_area);
  PlanarPoints corners;
  for (const PlanarRings& part : outline)
    corners.insert (corners.end(), part.front().begin(), part.front().end());
  PartedExtent parted{pcl_ops::extentOf ({convexHull (corners, 0.0)}, corners, frame),
                      {}};
  PlaneExtent& whole = parted.extent;
  whole.area = 0.0;
  for (const PlanarRings& part : outline) {
    PlaneExtent extent_of_part = pcl_ops::extentOf (part, part.front(), frame);
    whole.area += extent_of_part.area;
    const bool is_largest = &part == &outline.front();
    if (is_largest) {
      whole.hull = std::move (extent_of_part.hull);
      whole.holes = std::move (extent_of_part.holes);
    }
    else
      parted.other_parts.push_back (extent_of_part.rings());
  }
  return parted;
}

/** \brief Returns the entry of a plane in planes.json.
 * \param[in] id number of the plane, from 1 on */
Json
toObject (const Plan& plan,
          std::size_t id,
          const JoinedPlane& plane,
          const PlaneSegment& segment,
          const PlaneExtent& extent,
          const Polygons& other_parts,
          PlaneKind kind)
{
  Json object =
      planeObject (id, segment, extent, kind, Eigen::Vector3d::UnitZ(), other_parts);
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

/** \brief Returns the kind of a plane; lists of earlier versions have no kinds. */
PlaneKind
kindIn (const Json& plane)
{
  const std::string kind = plane.value ("kind", std::string());
  return kindCalled (kind).value_or (PlaneKind::Other);
}

/** \brief Removes all planes but the chosen ones from a list, and adds to the list how
 * many each option dropped. \return these numbers */
Dropped
choosePlanes (const PlaneChoice& choice, Json& list)
{
  const Json all_planes = std::move (list.at ("planes"));
  std::vector<PlaneSegment> segments;
  std::vector<PlaneKind> kinds;
  for (const Json& plane : all_planes) {
    segments.push_back (segmentIn (plane));
    kinds.push_back (kindIn (plane));
  }
  const auto extent_of = [&] (const PlaneSegment& segment) {
    const Json& plane = all_planes[std::size_t (&segment - segments.data())];
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
    chosen.push_back (all_planes[i]);
  if (!dropped.by_option.empty())
    list["dropped"] = toObject (dropped);
  list["planes"] = std::move (chosen);
  return dropped;
}

/** \brief Writes the picture of --image: the planes from above. */
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

/** \brief Writes the page of --view. */
void
saveView (const std::string& file,
          const std::string& title,
          const Json& list,
          const ForEachLabeledPoint& for_each_point)
{
  const PlaneSample sample = samplePlanes (list, for_each_point, max_points_on_page);
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
                  sample.groups});
}

std::size_t
countOfKind (PlaneKind kind, const Json& planes)
{
  return static_cast<std::size_t> (
      std::count_if (planes.begin(), planes.end(), [&] (const Json& plane) {
        return plane.value ("kind", std::string()) == toString (kind);
      }));
}

/** \brief Finds the floor plan of the planes in a list, writes it and returns it. */
FloorPlan
findAndSaveFloorPlan (const PlanesOutput& output,
                      const std::string& title,
                      const Json& list,
                      const ForEachLabeledPoint& for_each_point)
{
  // Enough for some hundred points per square meter of the walls of a large building.
  constexpr std::size_t sample_size = 4'000'000;
  const PlaneSample sample = samplePlanes (list, for_each_point, sample_size);
  std::vector<PlaneKind> kinds;
  std::vector<std::uint32_t> ids;
  for (const Json& plane : list.at ("planes")) {
    kinds.push_back (kindIn (plane));
    ids.push_back (plane.at ("id").get<std::uint32_t>());
  }
  const FloorPlan floor_plan = findFloorPlan (*sample.shifted.cloud,
                                              sample.planes,
                                              kinds,
                                              Eigen::Vector3d::UnitZ(),
                                              output.of_floor_plan,
                                              sample.shifted.shift);
  savePlan (output.floor_plan,
            floor_plan,
            ids,
            title,
            output.map.crs,
            output.of_floor_plan.meter);
  return floor_plan;
}

/** \brief Returns the name of the folder that a file is in. */
std::string
folderOf (const std::string& file)
{
  return fs::absolute (file).lexically_normal().parent_path().filename().string();
}

/** \brief Returns "1 plane", "2 planes" and so on. */
std::string
countedPlanes (std::size_t planes)
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
  const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  nameOrientations (segments, up, paper_angle_tolerance);
  turnUp (segments, up);
  Json json = {{"points", plan.points()},
               {"voxel_size", plan.grid.edge},
               {"tile", plan.grid.edgeOfTile()},
               {"tiles", tiles},
               {"planes", Json::array()}};
  std::vector<PlaneExtent> extents;
  std::vector<Polygons> other_parts;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    PartedExtent parted = extentOf (plan, segments[i], planes[i]);
    extents.push_back (std::move (parted.extent));
    other_parts.push_back (std::move (parted.other_parts));
  }
  const std::vector<PlaneKind> kinds = planeKinds (segments, extents, up, plan.meter);
  for (std::size_t i = 0; i < planes.size(); ++i)
    json["planes"].push_back (toObject (
        plan, i + 1, planes[i], segments[i], extents[i], other_parts[i], kinds[i]));
  return jsonText (json);
}

PlaneMessages
saveChosenPlanes (const std::string& list_file,
                  const ForEachLabeledPoint& for_each_point,
                  const PlanesOutput& output)
try {
  Json list = Json::parse (readTextFile (list_file, "planes.json"));
  PlaneMessages messages;
  messages.warnings = warningsIn (list);
  messages.counts = countedPlanes (list.at ("planes").size());
  if (output.files().empty())
    return messages;
  PlanCounts counts;
  counts.wall_planes_found = countOfKind (PlaneKind::Wall, list.at ("planes"));
  counts.has_floor = countOfKind (PlaneKind::Floor, list.at ("planes")) > 0;
  const Dropped dropped = choosePlanes (output.choice, list);
  if (!output.image.empty())
    saveImage (output.image, list.at ("planes"));
  if (!output.view.empty())
    saveView (output.view, folderOf (list_file), list, for_each_point);
  if (!output.floor_plan.empty()) {
    const FloorPlan floor_plan =
        findAndSaveFloorPlan (output, folderOf (list_file), list, for_each_point);
    counts.walls = floor_plan.walls.size();
    counts.wall_planes_kept = countOfKind (PlaneKind::Wall, list.at ("planes"));
    messages.file_notes.push_back (output.floor_plan + ": " + contentOf (floor_plan));
    constexpr bool is_in_tiles = true;
    putWarningOnPlan (counts, is_in_tiles, messages.warnings);
  }
  if (!output.planes.empty())
    writeTextFile (output.planes, planesFor (output.planes, list, output.map));
  const std::string reasons = dropped.reasons();
  messages.counts = countedPlanes (dropped.found) + "; " + output.files().front().name +
                    ": " + countedPlanes (list.at ("planes").size()) +
                    (reasons.empty() ? "" : ", dropped " + reasons);
  return messages;
}
catch (const Json::exception&) {
  throw WorkError (list_file, "is no list of planes; remove it and run it again");
}

} // namespace pcl_ops::apps
