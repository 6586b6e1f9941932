// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "mesh.h"

#include <io/output_file.h>
#include <picture/colors.h>

#ifdef PCL_OPS_WITH_SURFACE
#include <pcl_ops/surface/triangulation.h>
#endif

#include <cstdint>
#include <limits>
#include <locale>
#include <ostream>

namespace pcl_ops::apps {

namespace {

using Rings = std::vector<std::vector<Eigen::Vector3d>>;

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
  for (const Triangle& triangle : triangulateRings (outline))
    faces.push_back (pcl::Indices (triangle.begin(), triangle.end()));
#endif
  if (faces.empty()) {
    faces.emplace_back();
    for (std::size_t corner = 0; corner < rings.front().size(); ++corner)
      faces.back().push_back (static_cast<pcl::index_t> (corner));
  }
  return faces;
}

/** \brief A corner of an outline. */
struct Corner {
  Eigen::Vector3d place;
  pcl::RGB color;
};

struct Mesh {
  std::vector<Corner> corners;
  std::vector<pcl::Indices> faces;
  /** \brief Of coordinates, as PLY and VTK call it. */
  const char* type;
};

Mesh
toMesh (const Eigen::Isometry3d& pose,
        const std::vector<PlaneSegment>& planes,
        const std::vector<std::uint32_t>& ids,
        const std::vector<PlaneExtent>& extents)
{
  Mesh mesh{{}, {}, "float"};
  for (std::size_t p = 0; p < planes.size(); ++p) {
    const Rings rings = extents[p].rings();
    if (rings.empty())
      continue;
    const auto first = static_cast<pcl::index_t> (mesh.corners.size());
    for (pcl::Indices& face : facesOf (planes[p], extents[p].center, rings)) {
      for (pcl::index_t& corner : face)
        corner += first;
      mesh.faces.push_back (face);
    }
    const pcl::RGB color = colorOfLabel (ids[p]);
    for (const std::vector<Eigen::Vector3d>& ring : rings)
      for (const Eigen::Vector3d& corner : ring)
        mesh.corners.push_back ({pose * corner, color});
  }
  return mesh;
}

void
writePlace (const Corner& corner, std::ostream& stream)
{
  stream << corner.place.x() << ' ' << corner.place.y() << ' ' << corner.place.z();
}

void
writeFaces (const Mesh& mesh, std::ostream& stream)
{
  for (const pcl::Indices& face : mesh.faces) {
    stream << face.size();
    for (const pcl::index_t corner : face)
      stream << ' ' << corner;
    stream << '\n';
  }
}

void
writePly (const Mesh& mesh, std::ostream& stream)
{
  stream << "ply\nformat ascii 1.0\nelement vertex " << mesh.corners.size() << '\n';
  for (const char axis : {'x', 'y', 'z'})
    stream << "property " << mesh.type << ' ' << axis << '\n';
  stream << "property uchar red\nproperty uchar green\nproperty uchar blue\n"
            "element face "
         << mesh.faces.size()
         << "\nproperty list uint int vertex_indices\nend_header\n";
  for (const Corner& corner : mesh.corners) {
    writePlace (corner, stream);
    for (const int part : {corner.color.r, corner.color.g, corner.color.b})
      stream << ' ' << part;
    stream << '\n';
  }
  writeFaces (mesh, stream);
}

void
writeVtk (const Mesh& mesh, std::ostream& stream)
{
  constexpr float brightest = 255.0f;
  std::size_t numbers = mesh.faces.size();
  for (const pcl::Indices& face : mesh.faces)
    numbers += face.size();
  stream << "# vtk DataFile Version 3.0\noutlines of planes\nASCII\nDATASET POLYDATA\n"
            "POINTS "
         << mesh.corners.size() << ' ' << mesh.type << '\n';
  for (const Corner& corner : mesh.corners) {
    writePlace (corner, stream);
    stream << '\n';
  }
  stream << "POLYGONS " << mesh.faces.size() << ' ' << numbers << '\n';
  writeFaces (mesh, stream);
  stream << "POINT_DATA " << mesh.corners.size() << "\nCOLOR_SCALARS colors 3\n";
  for (const Corner& corner : mesh.corners)
    stream << corner.color.r / brightest << ' ' << corner.color.g / brightest << ' '
           << corner.color.b / brightest << '\n';
}

} // namespace

void
saveMesh (const std::string& file,
          const Eigen::Isometry3d& sensor_pose,
          const std::vector<PlaneSegment>& planes,
          const std::vector<std::uint32_t>& ids,
          const std::vector<PlaneExtent>& extents,
          Precision precision)
{
  const bool is_vtk = extensionOf (file) == ".vtk";
  const Eigen::Isometry3d pose = is_vtk ? sensor_pose : Eigen::Isometry3d::Identity();
  const bool is_double = precision == Precision::Double;
  Mesh mesh = toMesh (pose, planes, ids, extents);
  if (is_double)
    mesh.type = "double";
  // PCL's and VTK's writers want a name and do not tell of a full disk.
  writeFile (file, [&] (std::ostream& stream) {
    stream.imbue (std::locale::classic());
    stream.precision (is_double ? std::numeric_limits<double>::max_digits10
                                : std::numeric_limits<float>::max_digits10);
    is_vtk ? writeVtk (mesh, stream) : writePly (mesh, stream);
  });
}

} // namespace pcl_ops::apps
