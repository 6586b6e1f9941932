// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "mesh.h"

#include <picture/colors.h>

#ifdef PCL_OPS_WITH_SURFACE
#include <pcl_ops/surface/triangulation.h>
#endif

#include <optional>

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
  for (const Triangle& triangle : triangulate (outline))
    faces.push_back (pcl::Indices (triangle.begin(), triangle.end()));
#endif
  if (faces.empty()) {
    faces.emplace_back();
    for (std::size_t corner = 0; corner < rings.front().size(); ++corner)
      faces.back().push_back (static_cast<pcl::index_t> (corner));
  }
  return faces;
}

PolyData
toMesh (const std::vector<PlaneSegment>& planes,
        const std::vector<std::uint32_t>& ids,
        const std::vector<PlaneExtent>& extents,
        Precision precision)
{
  PolyData mesh{"outlines of planes", precision, {}, {}, {}, std::nullopt};
  for (std::size_t p = 0; p < planes.size(); ++p) {
    const Rings rings = extents[p].rings();
    if (rings.empty())
      continue;
    const auto first = static_cast<pcl::index_t> (mesh.points.size());
    for (pcl::Indices& face : facesOf (planes[p], extents[p].center, rings)) {
      for (pcl::index_t& corner : face)
        corner += first;
      mesh.cells.push_back (face);
    }
    const pcl::RGB color = colorOfLabel (ids[p]);
    for (const std::vector<Eigen::Vector3d>& ring : rings)
      mesh.points.insert (mesh.points.end(), ring.begin(), ring.end());
    mesh.colors.resize (mesh.points.size(), color);
  }
  return mesh;
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
  savePolyData (file, sensor_pose, toMesh (planes, ids, extents, precision));
}

} // namespace pcl_ops::apps
