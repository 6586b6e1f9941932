// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "mesh.h"

#include <pcl/io/ply_io.h>
#include <pcl/io/vtk_io.h>
#include <pcl/conversions.h>

#include <cli/errors.h>
#include <io/output_file.h>
#include <picture/colors.h>

#ifdef PCL_OPS_WITH_SURFACE
#include <pcl_ops/surface/triangulation.h>
#endif

#include <limits>

namespace pcl_ops::apps {

namespace {

/** \brief The faces of an outline, by its corners: triangles, or itself. */
std::vector<pcl::Indices>
facesOf ([[maybe_unused]] const PlaneSegment& plane, const PlaneExtent& extent)
{
  std::vector<pcl::Indices> faces;
#ifdef PCL_OPS_WITH_SURFACE
  const PlaneFrame frame (extent.center, plane.normal);
  PlanarPoints outline;
  for (const Eigen::Vector3d& corner : extent.hull)
    outline.push_back (frame.toPlane (corner));
  for (const Triangle& triangle : triangulate (outline))
    faces.push_back (pcl::Indices (triangle.begin(), triangle.end()));
#endif
  if (faces.empty()) {
    faces.emplace_back();
    for (std::size_t corner = 0; corner < extent.hull.size(); ++corner)
      faces.back().push_back (static_cast<pcl::index_t> (corner));
  }
  return faces;
}

pcl::PolygonMesh
toMesh (const Eigen::Isometry3d& pose,
        const std::vector<PlaneSegment>& planes,
        const std::vector<PlaneExtent>& extents)
{
  pcl::PointCloud<pcl::PointXYZRGB> corners;
  pcl::PolygonMesh mesh;
  for (std::size_t p = 0; p < planes.size(); ++p) {
    if (extents[p].hull.empty())
      continue;
    const auto first = static_cast<pcl::index_t> (corners.size());
    for (pcl::Indices& face : facesOf (planes[p], extents[p])) {
      pcl::Vertices polygon;
      for (const pcl::index_t corner : face)
        polygon.vertices.push_back (first + corner);
      mesh.polygons.push_back (polygon);
    }
    const pcl::RGB color = colorOfLabel (static_cast<std::uint32_t> (p + 1));
    for (const Eigen::Vector3d& corner : extents[p].hull) {
      pcl::PointXYZRGB point (color.r, color.g, color.b);
      point.getVector3fMap() = (pose * corner).cast<float>();
      corners.push_back (point);
    }
  }
  pcl::toPCLPointCloud2 (corners, mesh.cloud);
  return mesh;
}

// PCL refuses to write a mesh without points.
constexpr const char* empty_vtk =
    "# vtk DataFile Version 3.0\nno planes\nASCII\nDATASET POLYDATA\n"
    "POINTS 0 float\n";
constexpr const char* empty_ply =
    "ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\n"
    "property float y\nproperty float z\nelement face 0\n"
    "property list uchar int vertex_indices\nend_header\n";

} // namespace

void
saveMesh (const std::string& file,
          const Eigen::Isometry3d& sensor_pose,
          const std::vector<PlaneSegment>& planes,
          const std::vector<PlaneExtent>& extents)
{
  const bool is_vtk = extensionOf (file) == ".vtk";
  const Eigen::Isometry3d pose = is_vtk ? sensor_pose : Eigen::Isometry3d::Identity();
  const pcl::PolygonMesh mesh = toMesh (pose, planes, extents);
  if (mesh.polygons.empty())
    return writeTextFile (file, is_vtk ? empty_vtk : empty_ply);
  writeFile (file, [&] (const std::string& path) {
    constexpr unsigned digits = std::numeric_limits<float>::max_digits10;
    const int result = is_vtk ? pcl::io::saveVTKFile (path, mesh, digits)
                              : pcl::io::savePLYFileBinary (path, mesh);
    if (result < 0)
      throw WorkError (file, "cannot be written; is the disk full?");
  });
}

} // namespace pcl_ops::apps
