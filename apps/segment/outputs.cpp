// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/common/point_tests.h>

#include <boost/format.hpp>

#include "poly_data.h"
#include "report.h"
#include "stages.h"
#include <cli/text.h>
#include <drawing/edge_drawing.h>
#include <drawing/plan_drawing.h>
#include <io/las_file.h>
#include <io/output_file.h>
#include <io/output_folder.h>
#include <numbers/angles.h>
#include <page/plane_page.h>
#include <pcl_ops/plane_edges.h>
#include <picture/colors.h>
#include <picture/picture.h>

#include <filesystem>
#include <iostream>
#include <limits>
#include <numeric>
#include <regex>

namespace fs = std::filesystem;

#if PCL_OPS_WITH_SURFACE
#include <pcl_ops/surface/triangulation.h>
#endif

namespace pcl_ops::apps {

// Writes the output files of pcl_ops_segment; report.h declares saveOutputs and
// isPlaneFile.

namespace {

/** \brief Copies some points of a cloud. PCL's copyPointCloud is not used, as it counts
 * bytes in 32 bits. */
FileCloud
pointsOf (const FileCloud& cloud, const pcl::Indices& indices)
{
  const std::size_t step = cloud.points.point_step;
  FileCloud part = emptyLike (cloud, indices.size());
  part.points.data.reserve (indices.size() * step);
  for (const pcl::index_t index : indices) {
    const std::uint8_t* const point = cloud.points.data.data() + index * step;
    part.points.data.insert (part.points.data.end(), point, point + step);
  }
  return part;
}

/** \brief Divides an outline into triangles. Without pcl_ops_surface, or if that fails,
 * returns the outer ring as one face.
 * \param[in] center a point on the plane
 * \param[in] rings the outer ring first
 * \return faces as indices of corners, counted over all rings in their order */
std::vector<pcl::Indices>
facesOf ([[maybe_unused]] const PlaneSegment& plane,
         [[maybe_unused]] const Eigen::Vector3d& center,
         const Rings& rings)
{
  std::vector<pcl::Indices> faces;
#if PCL_OPS_WITH_SURFACE
  const PlaneFrame frame (center, plane.normal);
  PlanarRings outline;
  for (const Ring& ring : rings) {
    outline.emplace_back();
    for (const Eigen::Vector3d& corner : ring)
      outline.back().push_back (frame.toPlane (corner));
  }
  for (const Triangle& triangle : triangulate (outline))
    faces.push_back (pcl::Indices (triangle.begin(), triangle.end()));
#endif
  if (faces.empty()) {
    faces.emplace_back (rings.front().size());
    std::iota (faces.back().begin(), faces.back().end(), 0);
  }
  return faces;
}

/** \brief Returns edges as lines. PolyData::points has the corners first, then the ends
 * of edges that are not at a corner. */
PolyData
toLines (const PlaneEdges& found)
{
  constexpr bool are_lines = true, is_double = true;
  PolyData lines{are_lines, is_double};
  lines.corner_count = found.corners.size();
  for (const PlaneCorner& corner : found.corners)
    lines.points.push_back (corner.position);
  for (const PlaneEdge& edge : found.edges) {
    pcl::Indices& line = lines.cells.emplace_back();
    for (const Eigen::Vector3d& end : {edge.from, edge.to}) {
      // An end that was moved to a corner is exactly equal to it.
      std::size_t corner = 0;
      while (corner < lines.corner_count && lines.points[corner] != end)
        ++corner;
      const bool is_at_corner = corner < lines.corner_count;
      line.push_back (is_at_corner ? corner : lines.points.size());
      if (!is_at_corner)
        lines.points.push_back (end);
    }
    lines.planes_of_lines.emplace_back (edge.planes.begin(), edge.planes.end());
  }
  return lines;
}

std::string
toJson (const PlaneEdges& found)
{
  nlohmann::ordered_json json;
  json["edges"] = json["corners"] = nlohmann::ordered_json::array();
  for (const PlaneEdge& edge : found.edges)
    json["edges"].push_back ({{"planes", edge.planes},
                              {"from", edge.from},
                              {"to", edge.to},
                              {"length", edge.length()},
                              {"angle", toDegrees (edge.angle)}});
  for (const PlaneCorner& corner : found.corners)
    json["corners"].push_back (
        {{"planes", corner.planes}, {"position", corner.position}});
  return jsonText (json);
}

/** \brief Returns the signed distance of each point to its plane, positive on the
 * side that the normal points to; NaN for points on no plane.
 * \param[in] planes in the frame of the file */
std::vector<float>
distancesOf (const FileCloud& cloud, const std::vector<PlaneSegment>& planes)
{
  const CoordinateReader position_of (cloud);
  std::vector<float> distances (cloud.size(), std::numeric_limits<float>::quiet_NaN());
  for (const PlaneSegment& plane : planes)
    for (const std::size_t i : plane.inliers) {
      // Relative to the centroid: far from zero an equation's offset loses digits.
      distances[i] = plane.normal.dot (position_of (i) - plane.centroid);
    }
  return distances;
}

/** \brief Writes the labeled cloud.
 * \param[in] labels label of each point, 0 on no plane
 * \param[in] plane_ids as Report::planeIdsOfPieces */
void
saveLabeled (const std::string& file,
             const FileCloud& cloud,
             const std::vector<PlaneSegment>& planes,
             const std::vector<std::uint32_t>& labels,
             const std::vector<std::uint32_t>& plane_ids,
             const SegmentOptions& options)
{
  const std::vector<std::uint32_t> plane_id_of_point =
      plane_ids.empty() ? plane_ids : labelsOf (planes, cloud.size(), plane_ids);
  const std::vector<float> distances =
      options.has_distances ? distancesOf (cloud, planes) : std::vector<float>();
  if (isLasName (file))
    return saveLabeledLas (file, *cloud.las, labels, distances, plane_id_of_point);
  saveLabeledCloud (
      file, cloud, labels, distances, options.keeps_color, plane_id_of_point);
}

/** \brief Writes the finite points that are on no plane.
 * \param[in] labels label of each point, 0 on no plane
 * \return a description of the contents for messages */
std::string
saveRest (const std::string& file,
          const FileCloud& cloud,
          const ShiftedCloud& shifted,
          const std::vector<std::uint32_t>& labels)
{
  pcl::Indices rest;
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (labels[i] == 0 && pcl::isFinite ((*shifted.cloud)[i]))
      rest.push_back (i);
  saveCloud (file, pointsOf (cloud, rest));
  return counted (rest.size(), "point") + " on no plane";
}

/** \brief Writes the points of each plane as plane_001_horizontal.pcd and so on, where
 * 1 is the id of the plane, and removes plane files of earlier runs. The folder does
 * not change until all files are written.
 * \return a description of the contents for messages */
std::string
savePlaneClouds (const std::string& folder,
                 const FileCloud& cloud,
                 const Report& report,
                 const std::string& extension)
{
  const std::vector<PlaneSegment>& planes = report.detected.planes;
  fillFolder (folder, isPlaneFile, [&] (const fs::path& new_folder) {
    for (std::size_t i = 0; i < planes.size(); ++i) {
      const std::string name = str (boost::format ("plane_%03d_%s%s") % report.ids[i] %
                                    toString (planes[i].orientation) % extension);
      saveCloud (new_folder / name, pointsOf (cloud, planes[i].inliers));
    }
  });
  return counted (planes.size(), "plane") + ", each in a file";
}

/** \brief Writes outlines in the colors of the labeled cloud. Planes whose points span
 * no area have no outline.
 * \param[in] is_double as PolyData::is_double
 * \return a description of the contents for messages */
std::string
saveMesh (const std::string& file,
          const FileCloud& cloud,
          const Report& report,
          bool is_double)
{
  const std::vector<PlaneSegment>& planes = report.detected.planes;
  constexpr bool are_lines = false;
  PolyData mesh{are_lines, is_double};
  std::size_t outlines = 0;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const Rings rings = report.extents[i].rings();
    if (rings.empty())
      continue;
    ++outlines;
    const pcl::index_t first_corner = mesh.points.size();
    for (pcl::Indices& face : facesOf (planes[i], report.extents[i].center, rings)) {
      for (pcl::index_t& corner : face)
        corner += first_corner;
      mesh.cells.push_back (face);
    }
    for (const Ring& ring : rings)
      mesh.points.insert (mesh.points.end(), ring.begin(), ring.end());
    mesh.colors.resize (mesh.points.size(), colorOfLabel (report.ids[i]));
  }
  savePolyData (file, cloud, std::move (mesh));
  return counted (outlines, "outline");
}

/** \brief Writes where planes meet, with the ids of planes.
 * \param[in] meter length of a meter in the unit of the cloud
 * \return a description of the contents for messages */
std::string
saveEdges (const std::string& file,
           const FileCloud& cloud,
           const ShiftedCloud& shifted,
           const Report& report,
           const std::string& crs,
           double meter)
{
  PlaneEdges edges =
      findPlaneEdges (*shifted.cloud, report.detected.planes, {}, shifted.shift);
  const auto replace_indices_by_ids = [&] (auto& edges_or_corners) {
    for (auto& element : edges_or_corners)
      for (std::size_t& plane : element.planes)
        plane = report.ids[plane];
  };
  replace_indices_by_ids (edges.edges);
  replace_indices_by_ids (edges.corners);
  const std::string extension = extensionOf (file);
  if (extension == ".json")
    writeTextFile (file, toJson (edges));
  else if (extension == ".dxf")
    writeTextFile (file, toDxf (drawingOf (edges, meter)));
  else if (extension == ".geojson" || extension == ".gpkg")
    writeTextFile (file, mapFor (file, edgesToGeoJson (edges, crs), "edges"));
  else
    savePolyData (file, cloud, toLines (edges));
  return counted (edges.edges.size(), "edge") + ", " +
         counted (edges.corners.size(), "corner");
}

/** \brief Writes the floor plan.
 * \return a description of the contents for messages */
std::string
saveFloorPlan (const std::string& file,
               const Report& report,
               const SegmentOptions& options)
{
  const FloorPlan& plan = report.plan.value();
  const std::string title = fs::path (report.input).filename().string();
  savePlan (
      file, plan, report.ids, title, options.map.crs, options.plan_parameters.meter);
  return contentOf (plan);
}

/** \brief Writes the labeled cloud, the picture and the page for a browser. */
void
saveCloudPictureAndPage (const SegmentOptions& options,
                         const Outputs& outputs,
                         const FileCloud& cloud,
                         const ShiftedCloud& shifted,
                         const Report& report)
{
  const Detected& detected = report.detected;
  const std::vector<PlaneSegment>& planes = detected.planes;
  if (!outputs.cloud.empty())
    saveLabeled (outputs.cloud,
                 cloud,
                 planes,
                 labelsOf (planes, cloud.size(), report.ids),
                 report.planeIdsOfPieces(),
                 options);
  if (!outputs.image.empty())
    savePicture (outputs.image,
                 *shifted.cloud,
                 labelsOf (planes, cloud.size()),
                 planes,
                 detected.up,
                 report.ids);
  if (!outputs.view.empty())
    savePlanePage (
        outputs.view,
        {fs::path (report.input).filename().string(),
         shifted,
         planes,
         planeObjects (planes, report.extents, detected.kinds, report.ids, detected.up),
         detected.up});
}

/** \brief Writes the outputs whose contents the table does not show: all but those of
 * \ref saveCloudPictureAndPage and the list of planes.
 * \return a line with the contents of each output */
std::vector<std::string>
saveFilesWithNotes (const SegmentOptions& options,
                    const Outputs& outputs,
                    const FileCloud& cloud,
                    const ShiftedCloud& shifted,
                    const Report& report)
{
  const Detected& detected = report.detected;
  const std::vector<PlaneSegment>& planes = detected.planes;
  std::vector<std::string> notes;
  const auto note = [&] (const std::string& file, const std::string& contents) {
    notes.push_back (file + ": " + contents);
  };
  if (!outputs.mesh.empty()) {
    const bool is_double = !shifted.shift.isZero (0.0);
    note (outputs.mesh, saveMesh (outputs.mesh, cloud, report, is_double));
  }
  if (!outputs.edges.empty())
    note (outputs.edges,
          saveEdges (outputs.edges,
                     cloud,
                     shifted,
                     report,
                     options.map.crs,
                     options.plan_parameters.meter));
  if (!outputs.floor_plan.empty())
    note (outputs.floor_plan, saveFloorPlan (outputs.floor_plan, report, options));
  if (!outputs.rest.empty())
    note (
        outputs.rest,
        saveRest (
            outputs.rest, cloud, shifted, labelsOf (planes, cloud.size(), report.ids)));
  if (!outputs.planes_dir.empty())
    note (
        outputs.planes_dir,
        savePlaneClouds (outputs.planes_dir, cloud, report, options.cloudExtension()));
  if (!outputs.trace.empty())
    note (outputs.trace,
          saveStages (outputs.trace,
                      cloud,
                      detected.stages,
                      CloudPicture (*shifted.cloud,
                                    labelsOf (planes, cloud.size()),
                                    planes,
                                    detected.up)));
  return notes;
}

} // namespace

bool
isPlaneFile (const std::string& name)
{
  static const std::regex pattern (
      R"(plane_[0-9]{3,}_(horizontal|vertical|other)\.(pcd|ply))");
  return std::regex_match (name, pattern);
}

std::vector<std::string>
saveOutputs (const SegmentOptions& options,
             const Outputs& outputs,
             const FileCloud& cloud,
             const ShiftedCloud& shifted,
             const Report& report)
{
  saveCloudPictureAndPage (options, outputs, cloud, shifted, report);
  std::vector<std::string> notes =
      saveFilesWithNotes (options, outputs, cloud, shifted, report);
  // The list of planes comes last, so that a pipe gets its JSON when all files exist.
  if (outputs.planes.empty())
    return notes;
  const std::string list = planesFor (outputs.planes, toJson (report), options.map);
  if (outputs.planes == standard_stream)
    std::cout << list;
  else
    writeTextFile (outputs.planes, list);
  return notes;
}

} // namespace pcl_ops::apps
