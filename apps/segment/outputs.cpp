// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "outputs.h"

#include <pcl/common/point_tests.h>
#include <pcl/point_types.h>
#include <pcl/types.h>

#include <cli/errors.h>
#include <detection/plane_json.h>
#include <detection/plane_map.h>
#include <io/las_file.h>
#include <io/laz_file.h>
#include <io/output_file.h>
#include <nlohmann/json.hpp>
#include <numbers/angles.h>
#include <pcl_ops/orientation.h>
#include <pcl_ops/plane_edges.h>
#include <picture/colors.h>
#include <picture/picture.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <limits>
#include <locale>
#include <numeric>
#include <optional>
#include <ostream>
#include <regex>
#include <sstream>
#include <system_error>
#include <utility>

namespace fs = std::filesystem;

#ifdef PCL_OPS_WITH_SURFACE
#include <pcl_ops/surface/triangulation.h>
#endif

namespace pcl_ops::apps {

namespace {

/** \brief Of coordinates: PCL's point types cannot read doubles, and single precision
 * loses places far from zero. */
enum class Precision { Single, Double };

/** \brief Some points of a cloud. PCL's copyPointCloud counts bytes in 32 bits. */
FileCloud
pointsOf (const FileCloud& cloud, const pcl::Indices& indices)
{
  const std::size_t step = cloud.points.point_step;
  FileCloud part = emptyLike (cloud, indices.size());
  part.points.data.reserve (indices.size() * step);
  for (const pcl::index_t index : indices) {
    const std::uint8_t* const point =
        cloud.points.data.data() + static_cast<std::size_t> (index) * step;
    part.points.data.insert (part.points.data.end(), point, point + step);
  }
  return part;
}

std::string
planeFile (std::size_t id, const PlaneSegment& plane, const std::string& extension)
{
  std::ostringstream name;
  name << "plane_" << std::setfill ('0') << std::setw (3) << id << "_"
       << toString (plane.orientation) << extension;
  return name.str();
}

std::vector<fs::path>
planeFilesIn (const fs::path& folder)
{
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator (folder))
    if (entry.is_regular_file() && isPlaneFile (entry.path().filename().string()))
      files.push_back (entry.path());
  return files;
}

fs::path
temporaryFolderIn (const std::string& folder)
{
  std::string name = (fs::path (folder) / ".pcl_ops.XXXXXX").string();
  if (::mkdtemp (name.data()) == nullptr)
    throw fs::filesystem_error (folder,
                                std::error_code (errno, std::generic_category()));
  return name;
}

void
exchangePlanes (const fs::path& folder, const fs::path& with)
{
  // Other runs that exchange the planes of the folder wait for this one.
  const FolderLock lock (folder);
  lock.wait();
  std::vector<fs::path> stale = planeFilesIn (folder);
  const std::vector<fs::path> written = planeFilesIn (with);
  for (const fs::path& file : written)
    if (const fs::path target = folder / file.filename(); fs::is_directory (target))
      throw fs::filesystem_error (target.string(),
                                  std::make_error_code (std::errc::is_a_directory));
  for (const fs::path& file : written) {
    const fs::path target = folder / file.filename();
    fs::rename (file, target);
    stale.erase (std::remove (stale.begin(), stale.end(), target), stale.end());
  }
  for (const fs::path& file : stale)
    fs::remove (file);
}

struct Wires {
  /** \brief The first so many points are shown by themselves, too. */
  std::size_t corners;
  std::vector<std::array<std::size_t, 2>> planes;
};

/** \brief Polygons with a color for each corner, or lines. */
struct PolyData {
  Precision precision;
  std::vector<Eigen::Vector3d> points;
  std::vector<pcl::RGB> colors;
  std::vector<pcl::Indices> cells;
  /** \brief Not given: cells are polygons. */
  std::optional<Wires> wires;
};

/** \brief The type of coordinates, as PLY and VTK call it. */
const char*
typeOf (const PolyData& data)
{
  return data.precision == Precision::Double ? "double" : "float";
}

void
writePoint (const Eigen::Vector3d& point, std::ostream& stream)
{
  stream << point.x() << ' ' << point.y() << ' ' << point.z();
}

/** \brief Each cell with its number of points in front. */
void
writeCells (const std::vector<pcl::Indices>& cells, std::ostream& stream)
{
  for (const pcl::Indices& cell : cells) {
    stream << cell.size();
    for (const pcl::index_t point : cell)
      stream << ' ' << point;
    stream << '\n';
  }
}

void
writePlyHeader (const PolyData& data, std::ostream& stream)
{
  stream << "ply\nformat ascii 1.0\nelement vertex " << data.points.size() << '\n';
  for (const char axis : {'x', 'y', 'z'})
    stream << "property " << typeOf (data) << ' ' << axis << '\n';
  if (data.wires)
    stream << "element edge " << data.cells.size()
           << "\nproperty int vertex1\nproperty int vertex2\nproperty int plane1\n"
              "property int plane2\nend_header\n";
  else
    stream << "property uchar red\nproperty uchar green\nproperty uchar blue\n"
              "element face "
           << data.cells.size()
           << "\nproperty list uint int vertex_indices\nend_header\n";
}

void
writePly (const PolyData& data, std::ostream& stream)
{
  writePlyHeader (data, stream);
  for (std::size_t i = 0; i < data.points.size(); ++i) {
    writePoint (data.points[i], stream);
    if (!data.wires)
      for (const int part : {data.colors[i].r, data.colors[i].g, data.colors[i].b})
        stream << ' ' << part;
    stream << '\n';
  }
  if (!data.wires)
    return writeCells (data.cells, stream);
  for (std::size_t i = 0; i < data.cells.size(); ++i) {
    const auto& planes = data.wires->planes[i];
    stream << data.cells[i][0] << ' ' << data.cells[i][1] << ' ' << planes[0] << ' '
           << planes[1] << '\n';
  }
}

/** \brief Cells of a kind, after how many they are and how many numbers they take. */
void
writeSection (const char* kind,
              const std::vector<pcl::Indices>& cells,
              std::ostream& stream)
{
  std::size_t numbers = cells.size();
  for (const pcl::Indices& cell : cells)
    numbers += cell.size();
  stream << kind << ' ' << cells.size() << ' ' << numbers << '\n';
  writeCells (cells, stream);
}

void
writeVtk (const PolyData& data, std::ostream& stream)
{
  stream << "# vtk DataFile Version 3.0\n"
         << (data.wires ? "edges" : "outlines")
         << " of planes\nASCII\nDATASET POLYDATA\nPOINTS " << data.points.size() << ' '
         << typeOf (data) << '\n';
  for (const Eigen::Vector3d& point : data.points) {
    writePoint (point, stream);
    stream << '\n';
  }
  if (data.wires) {
    std::vector<pcl::Indices> corners;
    for (std::size_t i = 0; i < data.wires->corners; ++i)
      corners.push_back ({static_cast<pcl::index_t> (i)});
    writeSection ("VERTICES", corners, stream);
    return writeSection ("LINES", data.cells, stream);
  }
  writeSection ("POLYGONS", data.cells, stream);
  stream << "POINT_DATA " << data.points.size() << "\nCOLOR_SCALARS colors 3\n";
  for (const pcl::RGB& color : data.colors)
    stream << color.r / 255.0f << ' ' << color.g / 255.0f << ' ' << color.b / 255.0f
           << '\n';
}

/** \brief Writes an ASCII file: a .vtk for pcl_viewer, moved by the pose, else a .ply.
 */
void
savePolyData (const std::string& file,
              const Eigen::Isometry3d& sensor_pose,
              PolyData data)
{
  const bool is_vtk = extensionOf (file) == ".vtk";
  const Eigen::Isometry3d pose = is_vtk ? sensor_pose : Eigen::Isometry3d::Identity();
  for (Eigen::Vector3d& point : data.points)
    point = pose * point;
  // PCL's and VTK's writers want a name and do not tell of a full disk.
  writeFile (file, [&] (std::ostream& stream) {
    stream.imbue (std::locale::classic());
    stream.precision (data.precision == Precision::Double
                          ? std::numeric_limits<double>::max_digits10
                          : std::numeric_limits<float>::max_digits10);
    is_vtk ? writeVtk (data, stream) : writePly (data, stream);
  });
}

/** \brief The faces of an outline, by its corners, ring after ring: triangles, or the
 * outer ring itself. */
std::vector<pcl::Indices>
facesOf ([[maybe_unused]] const PlaneSegment& plane,
         [[maybe_unused]] const Eigen::Vector3d& center,
         const Rings& rings)
{
  std::vector<pcl::Indices> faces;
#ifdef PCL_OPS_WITH_SURFACE
  const PlaneFrame frame (center, plane.normal);
  PlanarRings outline;
  for (const std::vector<Eigen::Vector3d>& ring : rings) {
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
  PolyData lines{Precision::Double, {}, {}, {}, Wires{corners, {}}};
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
                              {"from", edge.from},
                              {"to", edge.to},
                              {"length", edge.length()},
                              {"angle", toDegrees (edge.angle)}});
  for (const PlaneCorner& corner : found.corners)
    json["corners"].push_back (
        {{"planes", corner.planes}, {"position", corner.position}});
  return jsonText (json);
}

/** \brief For each point of a cloud its signed distance to its plane, positive where
 * the normal points to [m]; NaN on no plane. \param[in] planes in the file's frame */
std::vector<float>
distancesOf (const FileCloud& cloud, const std::vector<PlaneSegment>& planes)
{
  const CoordinateReader place (cloud);
  std::vector<float> distances (cloud.size(), std::numeric_limits<float>::quiet_NaN());
  for (const PlaneSegment& plane : planes)
    for (const pcl::index_t inlier : plane.inliers) {
      const auto i = static_cast<std::size_t> (inlier);
      // From the centroid: an equation's offset has few digits left far from zero.
      distances[i] = static_cast<float> (plane.normal.dot (place (i) - plane.centroid));
    }
  return distances;
}

void
saveLabelled (const std::string& file,
              const FileCloud& cloud,
              const std::vector<PlaneSegment>& planes,
              const std::vector<std::uint32_t>& labels,
              const SegmentOptions& options)
{
  const std::vector<float> distances =
      options.distances ? distancesOf (cloud, planes) : std::vector<float>();
  if (isLasName (file))
    return saveLabelledLas (file, *cloud.las, labels, distances);
  saveLabelledCloud (file, cloud, labels, distances, options.keep_color);
}

Eigen::Isometry3d
poseOf (const FileCloud& cloud)
{
  return Eigen::Translation3d (cloud.origin.head<3>().cast<double>()) *
         cloud.orientation.cast<double>();
}

void
savePlanes (const std::string& file, const Report& report, const MapOptions& map)
{
  const std::string text = planesFor (file, toJson (report), map);
  if (file == standard_stream)
    std::cout << text;
  else
    writeTextFile (file, text);
}

/** \brief Writes the points on no plane, with all fields of the input, as a .pcd
 * or .ply; points
 * without coordinates are left out.
 * \param[in] shifted of the cloud's points
 * \param[in] labels per point, 0 for no plane
 * \throws WorkError if it cannot be written */
void
saveRest (const std::string& file,
          const FileCloud& cloud,
          const ShiftedCloud& shifted,
          const std::vector<std::uint32_t>& labels)
{
  pcl::Indices rest;
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (labels[i] == 0 && pcl::isFinite ((*shifted.cloud)[i]))
      rest.push_back (static_cast<pcl::index_t> (i));
  saveCloud (file, pointsOf (cloud, rest));
}

/** \brief Writes the points of each plane, with all fields of the input, as
 * plane_001_horizontal.pcd, plane_002_vertical.pcd and so on, numbered by
 * their ids. Files of such names that an earlier run has left are removed, so that the
 * folder has the planes of one cloud. Nothing changes there until all are written.
 * \param[in] folder is created where it is missing
 * \param[in] extension of the files, .pcd or .ply
 * \throws WorkError if the folder cannot be written to */
void
savePlaneClouds (const std::string& folder,
                 const FileCloud& cloud,
                 const Report& report,
                 const std::string& extension)
{
  const std::vector<PlaneSegment>& planes = report.detected.planes;
  makeFolder (folder);
  try {
    const TemporaryPath written (temporaryFolderIn (folder));
    for (std::size_t i = 0; i < planes.size(); ++i)
      saveCloud (
          (written.path() / planeFile (report.ids[i], planes[i], extension)).string(),
          pointsOf (cloud, planes[i].inliers));
    exchangePlanes (folder, written.path());
  }
  catch (const fs::filesystem_error& error) {
    throw OutputError (folder,
                       "cannot be written to (" + error.code().message() +
                           "); choose another folder");
  }
  catch (const OutputError& error) {
    throw OutputError (folder, error.problem); // the file's name is a temporary one
  }
}

/** \brief Writes the outlines of planes as a mesh in one step, each in the color its
 * points have in the labeled cloud. Outlines without area are left out.
 * \param[in] file a .ply in the file's frame, or a .vtk for pcl_viewer, which moves the
 * labeled cloud by the pose of its sensor, but no mesh: it is written moved
 * \throws WorkError if it cannot be written */
void
saveMesh (const std::string& file,
          const FileCloud& cloud,
          const Report& report,
          Precision precision)
{
  const std::vector<PlaneSegment>& planes = report.detected.planes;
  PolyData mesh{precision, {}, {}, {}, std::nullopt};
  for (std::size_t p = 0; p < planes.size(); ++p) {
    const Rings rings = report.extents[p].rings();
    if (rings.empty())
      continue;
    const auto first = static_cast<pcl::index_t> (mesh.points.size());
    for (pcl::Indices& face : facesOf (planes[p], report.extents[p].center, rings)) {
      for (pcl::index_t& corner : face)
        corner += first;
      mesh.cells.push_back (face);
    }
    const pcl::RGB color = colorOfLabel (report.ids[p]);
    for (const std::vector<Eigen::Vector3d>& ring : rings)
      mesh.points.insert (mesh.points.end(), ring.begin(), ring.end());
    mesh.colors.resize (mesh.points.size(), color);
  }
  savePolyData (file, poseOf (cloud), std::move (mesh));
}

/** \brief Writes where planes meet in one step, in double precision.
 * \param[in] file a .json or .ply in the file's frame, or a .vtk as \ref saveMesh
 * \throws WorkError if it cannot be written */
void
saveEdges (const std::string& file,
           const FileCloud& cloud,
           const ShiftedCloud& shifted,
           const Report& report)
{
  const PlaneEdges edges = numbered (
      findPlaneEdges (*shifted.cloud, report.detected.planes, {}, shifted.shift),
      report.ids);
  if (extensionOf (file) == ".json")
    return writeTextFile (file, toJson (edges));
  savePolyData (file, poseOf (cloud), toLines (edges));
}

} // namespace

bool
isPlaneFile (const std::string& name)
{
  static const std::regex pattern (
      R"(plane_[0-9]{3,}_(horizontal|vertical|other)\.(pcd|ply))");
  return std::regex_match (name, pattern);
}

void
saveOutputs (const SegmentOptions& options,
             const Outputs& outputs,
             const FileCloud& cloud,
             const ShiftedCloud& shifted,
             const Report& report)
{
  const std::vector<PlaneSegment>& planes = report.detected.planes;
  const std::vector<std::uint32_t> labels = labelsOf (planes, cloud.size(), report.ids);
  if (!outputs.cloud.empty())
    saveLabelled (outputs.cloud, cloud, planes, labels, options);
  if (!outputs.image.empty())
    savePicture (outputs.image,
                 *shifted.cloud,
                 labelsOf (planes, cloud.size()),
                 planes,
                 report.detected.up,
                 report.ids);
  if (!outputs.mesh.empty())
    saveMesh (outputs.mesh,
              cloud,
              report,
              shifted.shift.isZero (0.0) ? Precision::Single : Precision::Double);
  if (!outputs.edges.empty())
    saveEdges (outputs.edges, cloud, shifted, report);
  if (!outputs.rest.empty())
    saveRest (outputs.rest, cloud, shifted, labels);
  if (!outputs.planes_dir.empty())
    savePlaneClouds (outputs.planes_dir, cloud, report, options.fileFormat());
  // Last: a pipe gets its JSON when the files are there.
  if (!outputs.planes.empty())
    savePlanes (outputs.planes, report, options.map);
}

} // namespace pcl_ops::apps
