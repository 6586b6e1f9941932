// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "poly_data.h"

#include <io/output_file.h>

#include <limits>
#include <locale>
#include <ostream>

namespace pcl_ops::apps {

namespace {

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
  constexpr float brightest = 255.0f;
  stream << "# vtk DataFile Version 3.0\n"
         << data.title << "\nASCII\nDATASET POLYDATA\nPOINTS " << data.points.size()
         << ' ' << typeOf (data) << '\n';
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
    stream << color.r / brightest << ' ' << color.g / brightest << ' '
           << color.b / brightest << '\n';
}

} // namespace

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

} // namespace pcl_ops::apps
