// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/common/point_tests.h>

#include <boost/format.hpp>

#include "report.h"
#include "stages.h"
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
#include <locale>
#include <numeric>
#include <ostream>
#include <regex>

namespace fs = std::filesystem;

#if PCL_OPS_WITH_SURFACE
#include <pcl_ops/surface/triangulation.h>
#endif

namespace pcl_ops::apps {

// Writes all output files of pcl_ops_segment; report.h declares saveOutputs.

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

/** \brief A mesh of polygons with a color per corner, or lines without color. */
struct PolyData {
  bool are_lines;
  /** \brief Whether coordinates are written as doubles. PCL's point types cannot read
   * these, but single precision loses digits far from zero. */
  bool is_double;
  /** \brief Name of the coordinate type in PLY and VTK. */
  const char* type = is_double ? "double" : "float";
  std::vector<Eigen::Vector3d> points = {};
  std::vector<pcl::RGB> colors = {};
  std::vector<pcl::Indices> cells = {};
  /** \brief For lines: the planes of each line, and how many of the first points are
   * corners, shown as vertices. */
  std::vector<pcl::Indices> planes = {};
  std::size_t corners = 0;
};

std::ostream&
operator<< (std::ostream& stream, const pcl::Indices& cell)
{
  for (std::size_t i = 0; i < cell.size(); ++i)
    stream << (i == 0 ? "" : " ") << cell[i];
  return stream;
}

const Eigen::IOFormat in_a_row (Eigen::StreamPrecision, Eigen::DontAlignCols, " ", " ");

void
writePly (const PolyData& data, std::ostream& stream)
{
  stream << "ply\nformat ascii 1.0\nelement vertex " << data.points.size() << '\n';
  for (const char axis : {'x', 'y', 'z'})
    stream << "property " << data.type << ' ' << axis << '\n';
  if (data.are_lines)
    stream << "element edge " << data.cells.size()
           << "\nproperty int vertex1\nproperty int vertex2\nproperty int plane1\n"
              "property int plane2\nend_header\n";
  else
    stream << "property uchar red\nproperty uchar green\nproperty uchar blue\n"
              "element face "
           << data.cells.size()
           << "\nproperty list uint int vertex_indices\nend_header\n";
  for (std::size_t i = 0; i < data.points.size(); ++i) {
    stream << data.points[i].format (in_a_row);
    if (!data.are_lines)
      stream << ' ' << data.colors[i].getRGBVector3i().format (in_a_row);
    stream << '\n';
  }
  for (std::size_t i = 0; i < data.cells.size(); ++i)
    if (data.are_lines)
      stream << data.cells[i] << ' ' << data.planes[i] << '\n';
    else
      stream << data.cells[i].size() << ' ' << data.cells[i] << '\n';
}

/** \brief Writes a Wavefront mesh. A vertex has its color after its coordinates, as
 * MeshLab, Blender and Open3D read it. */
void
writeObj (const PolyData& data, std::ostream& stream)
{
  stream << "# outlines of planes\n";
  for (std::size_t i = 0; i < data.points.size(); ++i)
    stream << "v " << data.points[i].format (in_a_row) << ' '
           << (data.colors[i].getRGBVector3i().cast<float>() / 255.0f).format (in_a_row)
           << '\n';
  for (pcl::Indices cell : data.cells) {
    for (pcl::index_t& corner : cell)
      ++corner;
    stream << "f " << cell << '\n';
  }
}

/** \brief Writes a section of a VTK file: number of cells, count of all integers, then
 * the cells. */
void
writeSection (const char* kind,
              const std::vector<pcl::Indices>& cells,
              std::ostream& stream)
{
  std::size_t numbers = cells.size();
  for (const pcl::Indices& cell : cells)
    numbers += cell.size();
  stream << kind << ' ' << cells.size() << ' ' << numbers << '\n';
  for (const pcl::Indices& cell : cells)
    stream << cell.size() << ' ' << cell << '\n';
}

void
writeVtk (const PolyData& data, std::ostream& stream)
{
  stream << "# vtk DataFile Version 3.0\n"
         << (data.are_lines ? "edges" : "outlines")
         << " of planes\nASCII\nDATASET POLYDATA\nPOINTS " << data.points.size() << ' '
         << data.type << '\n';
  for (const Eigen::Vector3d& point : data.points)
    stream << point.format (in_a_row) << '\n';
  if (data.are_lines) {
    std::vector<pcl::Indices> corners;
    for (std::size_t i = 0; i < data.corners; ++i)
      corners.push_back ({static_cast<pcl::index_t> (i)});
    writeSection ("VERTICES", corners, stream);
    return writeSection ("LINES", data.cells, stream);
  }
  writeSection ("POLYGONS", data.cells, stream);
  stream << "POINT_DATA " << data.points.size() << "\nCOLOR_SCALARS colors 3\n";
  for (const pcl::RGB& color : data.colors)
    stream << (color.getRGBVector3i().cast<float>() / 255.0f).format (in_a_row) << '\n';
}

/** \brief Writes an ASCII file. A .ply or .obj is in the frame of the input file. A
 * .vtk is moved by the pose of the sensor, as pcl_viewer moves clouds by that pose but
 * not meshes. */
void
savePolyData (const std::string& file, const FileCloud& cloud, PolyData data)
{
  const bool is_vtk = extensionOf (file) == ".vtk";
  const Eigen::Isometry3d pose =
      Eigen::Translation3d (cloud.origin.head<3>().cast<double>()) *
      cloud.orientation.cast<double>();
  if (is_vtk)
    for (Eigen::Vector3d& point : data.points)
      point = pose * point;
  // PCL's and VTK's writers are not used: they do not report a full disk.
  writeFile (file, [&] (std::ostream& stream) {
    stream.imbue (std::locale::classic());
    stream.precision (data.is_double ? std::numeric_limits<double>::max_digits10
                                     : std::numeric_limits<float>::max_digits10);
    if (is_vtk)
      writeVtk (data, stream);
    else if (extensionOf (file) == ".obj")
      writeObj (data, stream);
    else
      writePly (data, stream);
  });
}

/** \brief Divides an outline into triangles, as indices of its corners. Without
 * pcl_ops_surface, or if that fails, returns the outer ring as one face. */
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

/** \brief Returns edges as lines. Points are the corners first, then the ends of edges
 * that are not at a corner. */
PolyData
toLines (const PlaneEdges& found)
{
  PolyData lines{true, true};
  lines.corners = found.corners.size();
  for (const PlaneCorner& corner : found.corners)
    lines.points.push_back (corner.position);
  for (const PlaneEdge& edge : found.edges) {
    pcl::Indices& line = lines.cells.emplace_back();
    for (const Eigen::Vector3d& end : {edge.from, edge.to}) {
      // An end that was moved to a corner is exactly equal to it.
      std::size_t i = 0;
      while (i < lines.corners && lines.points[i] != end)
        ++i;
      line.push_back (i < lines.corners ? i : lines.points.size());
      if (i == lines.corners)
        lines.points.push_back (end);
    }
    lines.planes.emplace_back (edge.planes.begin(), edge.planes.end());
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

/** \brief Returns the signed distance of each point to its plane [m], positive on the
 * side that the normal points to; NaN for points on no plane.
 * \param[in] planes in the frame of the file */
std::vector<float>
distancesOf (const FileCloud& cloud, const std::vector<PlaneSegment>& planes)
{
  const CoordinateReader place (cloud);
  std::vector<float> distances (cloud.size(), std::numeric_limits<float>::quiet_NaN());
  for (const PlaneSegment& plane : planes)
    for (const std::size_t i : plane.inliers) {
      // Relative to the centroid: far from zero an equation's offset loses digits.
      distances[i] = plane.normal.dot (place (i) - plane.centroid);
    }
  return distances;
}

void
saveLabelled (const std::string& file,
              const FileCloud& cloud,
              const std::vector<PlaneSegment>& planes,
              const std::vector<std::uint32_t>& labels,
              const std::vector<std::uint32_t>& lies_on,
              const SegmentOptions& options)
{
  const std::vector<std::uint32_t> of_points =
      lies_on.empty() ? lies_on : labelsOf (planes, cloud.size(), lies_on);
  const std::vector<float> distances =
      options.distances ? distancesOf (cloud, planes) : std::vector<float>();
  if (isLasName (file))
    return saveLabelledLas (file, *cloud.las, labels, distances, of_points);
  saveLabelledCloud (file, cloud, labels, distances, options.keep_color, of_points);
}

std::string
counted (std::size_t number, const std::string& noun)
{
  return std::to_string (number) + " " + noun + (number == 1 ? "" : "s");
}

/** \brief Writes the finite points that are on no plane.
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

/** \brief Writes the points of each plane as plane_001_horizontal.pcd and so on, by
 * ids, and removes plane files of earlier runs. The folder does not change until all
 * files are written.
 * \return a description of the contents for messages */
std::string
savePlaneClouds (const std::string& folder,
                 const FileCloud& cloud,
                 const Report& report,
                 const std::string& extension)
{
  const std::vector<PlaneSegment>& planes = report.detected.planes;
  fillFolder (folder, isPlaneFile, [&] (const fs::path& written) {
    for (std::size_t i = 0; i < planes.size(); ++i) {
      const std::string name = str (boost::format ("plane_%03d_%s%s") % report.ids[i] %
                                    toString (planes[i].orientation) % extension);
      saveCloud (written / name, pointsOf (cloud, planes[i].inliers));
    }
  });
  return counted (planes.size(), "plane") + ", each in a file";
}

/** \brief Writes outlines in the colors of the labeled cloud. Planes whose points span
 * no area have no outline.
 * \return a description of the contents for messages */
std::string
saveMesh (const std::string& file,
          const FileCloud& cloud,
          const Report& report,
          bool is_double)
{
  const std::vector<PlaneSegment>& planes = report.detected.planes;
  PolyData mesh{false, is_double};
  std::size_t outlines = 0;
  for (std::size_t p = 0; p < planes.size(); ++p) {
    const Rings rings = report.extents[p].rings();
    if (rings.empty())
      continue;
    ++outlines;
    const pcl::index_t first = mesh.points.size();
    for (pcl::Indices& face : facesOf (planes[p], report.extents[p].center, rings)) {
      for (pcl::index_t& corner : face)
        corner += first;
      mesh.cells.push_back (face);
    }
    for (const Ring& ring : rings)
      mesh.points.insert (mesh.points.end(), ring.begin(), ring.end());
    mesh.colors.resize (mesh.points.size(), colorOfLabel (report.ids[p]));
  }
  savePolyData (file, cloud, std::move (mesh));
  return counted (outlines, "outline");
}

/** \brief Writes the edges of the planes in the format of the file's extension.
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
  const auto number = [&] (auto& of_planes) {
    for (auto& element : of_planes)
      for (std::size_t& plane : element.planes)
        plane = report.ids[plane];
  };
  number (edges.edges);
  number (edges.corners);
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
  const std::vector<PlaneSegment>& planes = report.detected.planes;
  const std::vector<std::uint32_t> labels = labelsOf (planes, cloud.size(), report.ids);
  std::vector<std::string> written;
  const auto note = [&] (const std::string& file, const std::string& content) {
    written.push_back (file + ": " + content);
  };
  if (!outputs.cloud.empty())
    saveLabelled (
        outputs.cloud, cloud, planes, labels, report.planesOfPieces(), options);
  if (!outputs.image.empty())
    savePicture (outputs.image,
                 *shifted.cloud,
                 labelsOf (planes, cloud.size()),
                 planes,
                 report.detected.up,
                 report.ids);
  if (!outputs.view.empty())
    savePlanePage (outputs.view,
                   {fs::path (report.input).filename().string(),
                    shifted,
                    planes,
                    planeObjects (planes,
                                  report.extents,
                                  report.detected.kinds,
                                  report.ids,
                                  report.detected.up),
                    report.detected.up});
  if (!outputs.mesh.empty())
    note (outputs.mesh,
          saveMesh (outputs.mesh, cloud, report, !shifted.shift.isZero (0.0)));
  if (!outputs.edges.empty())
    note (outputs.edges,
          saveEdges (outputs.edges,
                     cloud,
                     shifted,
                     report,
                     options.map.crs,
                     options.of_plan.meter));
  if (!outputs.plan.empty()) {
    savePlan (outputs.plan,
              report.plan.value(),
              report.ids,
              fs::path (report.input).filename().string(),
              options.map.crs,
              options.of_plan.meter);
    note (outputs.plan, contentOf (*report.plan));
  }
  if (!outputs.rest.empty())
    note (outputs.rest, saveRest (outputs.rest, cloud, shifted, labels));
  if (!outputs.planes_dir.empty())
    note (outputs.planes_dir,
          savePlaneClouds (outputs.planes_dir, cloud, report, options.fileFormat()));
  if (!outputs.trace.empty())
    note (outputs.trace,
          saveStages (outputs.trace,
                      cloud,
                      report.detected.stages,
                      CloudPicture (*shifted.cloud,
                                    labelsOf (planes, cloud.size()),
                                    planes,
                                    report.detected.up)));
  // Last, so that a pipe gets its JSON when all files exist.
  if (outputs.planes.empty())
    return written;
  const std::string text = planesFor (outputs.planes, toJson (report), options.map);
  if (outputs.planes == standard_stream)
    std::cout << text;
  else
    writeTextFile (outputs.planes, text);
  return written;
}

} // namespace pcl_ops::apps
