// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "poly_data.h"

#include <Eigen/Geometry>

#include <io/output_file.h>

#include <limits>
#include <locale>
#include <ostream>

namespace pcl_ops::apps {

namespace {

/** \brief Returns the name of the coordinate type in PLY and VTK. */
const char*
coordinateType (const PolyData& data)
{
  return data.is_double ? "double" : "float";
}

/** \brief Returns red, green and blue from 0 to 1. */
Eigen::Vector3f
fractionsOf (const pcl::RGB& color)
{
  constexpr float max_component = 255.0f;
  return color.getRGBVector3i().cast<float>() / max_component;
}

/** \brief Writes indices with spaces between them. */
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
    stream << "property " << coordinateType (data) << ' ' << axis << '\n';
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
      stream << data.cells[i] << ' ' << data.planes_of_lines[i] << '\n';
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
           << fractionsOf (data.colors[i]).format (in_a_row) << '\n';
  for (pcl::Indices cell : data.cells) {
    for (pcl::index_t& corner : cell)
      ++corner; // OBJ counts from 1 on
    stream << "f " << cell << '\n';
  }
}

/** \brief Writes a section of a VTK file. Its header has the number of cells and the
 * number of integers in the section, each line a cell: its size and its indices. */
void
writeVtkSection (const char* kind,
                 const std::vector<pcl::Indices>& cells,
                 std::ostream& stream)
{
  std::size_t integers = cells.size(); // the sizes
  for (const pcl::Indices& cell : cells)
    integers += cell.size();
  stream << kind << ' ' << cells.size() << ' ' << integers << '\n';
  for (const pcl::Indices& cell : cells)
    stream << cell.size() << ' ' << cell << '\n';
}

void
writeVtk (const PolyData& data, std::ostream& stream)
{
  stream << "# vtk DataFile Version 3.0\n"
         << (data.are_lines ? "edges" : "outlines")
         << " of planes\nASCII\nDATASET POLYDATA\nPOINTS " << data.points.size() << ' '
         << coordinateType (data) << '\n';
  for (const Eigen::Vector3d& point : data.points)
    stream << point.format (in_a_row) << '\n';
  if (data.are_lines) {
    std::vector<pcl::Indices> vertices;
    for (std::size_t i = 0; i < data.corner_count; ++i)
      vertices.push_back ({static_cast<pcl::index_t> (i)});
    writeVtkSection ("VERTICES", vertices, stream);
    writeVtkSection ("LINES", data.cells, stream);
    return;
  }
  writeVtkSection ("POLYGONS", data.cells, stream);
  stream << "POINT_DATA " << data.points.size() << "\nCOLOR_SCALARS colors 3\n";
  for (const pcl::RGB& color : data.colors)
    stream << fractionsOf (color).format (in_a_row) << '\n';
}

} // namespace

void
savePolyData (const std::string& file, const FileCloud& cloud, PolyData data)
{
  const std::string extension = extensionOf (file);
  const Eigen::Isometry3d pose =
      Eigen::Translation3d (cloud.origin.head<3>().cast<double>()) *
      cloud.orientation.cast<double>();
  if (extension == ".vtk")
    for (Eigen::Vector3d& point : data.points)
      point = pose * point;
  // PCL's and VTK's writers are not used: they do not report a full disk.
  writeFile (file, [&] (std::ostream& stream) {
    stream.imbue (std::locale::classic());
    stream.precision (data.is_double ? std::numeric_limits<double>::max_digits10
                                     : std::numeric_limits<float>::max_digits10);
    if (extension == ".vtk")
      writeVtk (data, stream);
    else if (extension == ".obj")
      writeObj (data, stream);
    else
      writePly (data, stream);
  });
}

} // namespace pcl_ops::apps
