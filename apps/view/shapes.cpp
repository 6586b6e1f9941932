// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "shapes.h"

namespace pcl_ops::apps {

namespace {

using namespace pcl::visualization;

constexpr const char* corners_id = "corners";

pcl::PointXYZ
toPoint (const Eigen::Vector3d& position)
{
  const Eigen::Vector3f p = position.cast<float>();
  return {p.x(), p.y(), p.z()};
}

std::string
nextId (PCLVisualizer& viewer)
{
  return "shape " + std::to_string (viewer.getShapeActorMap()->size());
}

/** \brief Draws a closed line. */
void
drawLine (PCLVisualizer& viewer,
          const std::vector<Eigen::Vector3d>& corners,
          const Eigen::Vector3d& color)
{
  const auto cloud = pcl::make_shared<XyzCloud>();
  for (const Eigen::Vector3d& corner : corners)
    cloud->push_back (toPoint (corner));
  const std::string id = nextId (viewer);
  viewer.addPolygon<pcl::PointXYZ> (cloud, color[0], color[1], color[2], id);
  auto& line = dynamic_cast<vtkActor&> (*viewer.getShapeActorMap()->at (id));
  line.GetProperty()->SetLineWidth (3.0);
  line.GetProperty()->LightingOff();
}

void
drawCorners (PCLVisualizer& viewer, const std::vector<PlaneCorner>& corners)
{
  const auto cloud = pcl::make_shared<XyzCloud>();
  for (const PlaneCorner& corner : corners)
    cloud->push_back (toPoint (corner.position));
  viewer.addPointCloud<pcl::PointXYZ> (
      cloud,
      PointCloudColorHandlerCustom<pcl::PointXYZ> (cloud, 220, 0, 0),
      corners_id);
  viewer.setPointCloudRenderingProperties (PCL_VISUALIZER_POINT_SIZE, 14.0, corners_id);
}

} // namespace

void
drawShapes (PCLVisualizer& viewer,
            const FoundPlanes& found,
            const ViewState& state,
            double arrow)
{
  viewer.removeAllShapes();
  viewer.removePointCloud (corners_id);
  for (std::uint32_t id = 1; id <= found.extents.size(); ++id) {
    const pcl::RGB color = colorOfPlane (found, state, id);
    // The color of the plane itself would be lost among its points.
    const Eigen::Vector3d dark =
        Eigen::Vector3d (color.r, color.g, color.b) / (2.0 * 255.0);
    const PlaneSegment& plane = found.detected.planes[id - 1];
    const pcl::PointXYZ tip = toPoint (plane.centroid + arrow * plane.normal);
    const pcl::PointXYZ foot = toPoint (plane.centroid);
    if (state.hulls)
      drawLine (viewer, found.extents[id - 1].hull, dark);
    if (state.normals)
      viewer.addArrow (tip, foot, dark[0], dark[1], dark[2], false, nextId (viewer));
  }
  if (!state.edges)
    return;
  for (const PlaneEdge& edge : found.edges.edges)
    drawLine (viewer, {edge.from, edge.to}, Eigen::Vector3d::Zero());
  drawCorners (viewer, found.edges.corners);
}

} // namespace pcl_ops::apps
