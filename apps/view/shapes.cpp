// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "shapes.h"

#include <Eigen/Geometry>

namespace pcl_ops::apps {

namespace {

using pcl::visualization::PCLVisualizer;

constexpr const char* corners_id = "corners";

/** \brief Diagonal of the box around all outlines. */
double
diagonalOf (const std::vector<PlaneExtent>& extents)
{
  Eigen::AlignedBox3d box;
  for (const PlaneExtent& extent : extents)
    for (const Eigen::Vector3d& corner : extent.hull)
      box.extend (corner);
  return box.isEmpty() ? 1.0 : box.diagonal().norm();
}

XyzCloud::Ptr
toCloud (const std::vector<Eigen::Vector3d>& positions)
{
  auto cloud = pcl::make_shared<XyzCloud>();
  for (const Eigen::Vector3d& position : positions)
    cloud->emplace_back (static_cast<float> (position.x()),
                         static_cast<float> (position.y()),
                         static_cast<float> (position.z()));
  return cloud;
}

/** \brief Keeps the points of a cloud from hiding what is drawn among them. */
void
bringForward (vtkActor& actor)
{
  constexpr double towards_eye = -8.0;
  vtkMapper& mapper = *actor.GetMapper();
  mapper.SetResolveCoincidentTopologyToPolygonOffset();
  mapper.SetRelativeCoincidentTopologyLineOffsetParameters (towards_eye, towards_eye);
  mapper.SetRelativeCoincidentTopologyPointOffsetParameter (towards_eye);
}

/** \brief Draws a closed line in front of the points it lies among. */
void
drawRing (PCLVisualizer& viewer,
          const std::vector<Eigen::Vector3d>& corners,
          const Eigen::Vector3d& color)
{
  const std::string id = "ring " + std::to_string (viewer.getShapeActorMap()->size());
  if (!viewer.addPolygon<pcl::PointXYZ> (
          toCloud (corners), color[0], color[1], color[2], id))
    return;
  auto& actor = dynamic_cast<vtkActor&> (*viewer.getShapeActorMap()->at (id));
  actor.GetProperty()->SetLineWidth (3.0);
  actor.GetProperty()->LightingOff();
  bringForward (actor);
}

/** \brief Draws an arrow from the centroid of a plane along its normal. */
void
drawNormal (PCLVisualizer& viewer,
            const PlaneSegment& plane,
            double length,
            const Eigen::Vector3d& color)
{
  const XyzCloud::Ptr ends =
      toCloud ({plane.centroid + length * plane.normal, plane.centroid});
  const std::string id = "normal " + std::to_string (viewer.getShapeActorMap()->size());
  viewer.addArrow (
      ends->front(), ends->back(), color[0], color[1], color[2], false, id);
}

/** \brief Draws where planes meet. */
void
drawEdges (PCLVisualizer& viewer, const PlaneEdges& edges)
{
  for (const PlaneEdge& edge : edges.edges)
    drawRing (viewer, {edge.from, edge.to}, Eigen::Vector3d::Zero());
  std::vector<Eigen::Vector3d> corners;
  for (const PlaneCorner& corner : edges.corners)
    corners.push_back (corner.position);
  const XyzCloud::Ptr cloud = toCloud (corners);
  viewer.addPointCloud<pcl::PointXYZ> (
      cloud,
      pcl::visualization::PointCloudColorHandlerCustom<pcl::PointXYZ> (
          cloud, 220, 0, 0),
      corners_id);
  viewer.setPointCloudRenderingProperties (
      pcl::visualization::PCL_VISUALIZER_POINT_SIZE, 14.0, corners_id);
  bringForward (*viewer.getCloudActorMap()->at (corners_id).actor);
}

} // namespace

void
drawShapes (PCLVisualizer& viewer, const FoundPlanes& found, const ViewState& state)
{
  viewer.removeAllShapes();
  viewer.removePointCloud (corners_id);
  const double arrow = 0.04 * diagonalOf (found.extents);
  const std::vector<pcl::RGB> colors = planeColors (found, state);
  for (std::size_t i = 0; i < colors.size(); ++i) {
    // The color of the plane itself would be lost among its points.
    const Eigen::Vector3d dark =
        Eigen::Vector3d (colors[i].r, colors[i].g, colors[i].b) / (2.0 * 255.0);
    if (state.hulls)
      drawRing (viewer, found.extents[i].hull, dark);
    if (state.normals)
      drawNormal (viewer, found.planes[i], arrow, dark);
  }
  if (state.edges)
    drawEdges (viewer, found.edges);
}

} // namespace pcl_ops::apps
