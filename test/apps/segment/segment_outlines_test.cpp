// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>

#include "segment_program.h"

#include <cmath>
#include <regex>
#include <sstream>

namespace {

using Eigen::Vector3d;
using Json = nlohmann::json;

/** \brief A .ply or .vtk in text, as others read it. */
struct Drawing {
  std::vector<Vector3d> points;
  /** \brief The numbers of each face. */
  std::vector<std::vector<double>> faces;
};

Drawing
readDrawing (const std::string& text)
{
  std::smatch points;
  std::regex_search (text, points, std::regex ("(?:element vertex|POINTS) ([0-9]+)"));
  // A .vtk goes on with the colors.
  std::istringstream stream (text.substr (0, text.find ("POINT_DATA")));
  Drawing drawing;
  for (std::string line; std::getline (stream, line);) {
    if (line.find_first_not_of ("0123456789.e+- ") < line.size())
      continue;
    const std::vector<double> numbers = numbersIn (line);
    if (drawing.points.size() < std::stoul (points[1]))
      drawing.points.emplace_back (numbers.at (0), numbers.at (1), numbers.at (2));
    else
      drawing.faces.push_back (numbers);
  }
  return drawing;
}

TEST_F (Segment, WritesHullsAsAMeshThatLiesOnTheCloudInPclViewer)
{
  // pcl_viewer moves a cloud by the pose of its sensor, and a mesh by nothing.
  InputCloud posed = floorAndWall();
  posed.sensor_orientation_ = Eigen::AngleAxisf (0.5f, Eigen::Vector3f::UnitY());
  save ("posed.pcd", posed);
  folder_.write ("utm.las", lasBytes (floorAndWallInLas()));
  const Eigen::Isometry3d none = Eigen::Isometry3d::Identity();
  const Eigen::Isometry3d pose =
      Eigen::Translation3d (posed.sensor_origin_.head<3>().cast<double>()) *
      posed.sensor_orientation_.cast<double>();
  for (const auto& [cloud, mesh, moved] : {std::tuple ("posed.pcd", "m.ply", none),
                                           std::tuple ("posed.pcd", "m.vtk", pose),
                                           std::tuple ("utm.las", "m.ply", none),
                                           std::tuple ("utm.las", "m.vtk", none)}) {
    SCOPED_TRACE (cloud + std::string (" ") + mesh);
    const Json json = jsonOf (cloud + std::string (" --mesh ") + mesh);
    const Drawing drawing = readDrawing (contentOf (folder_ / mesh));
    EXPECT_GE (drawing.faces.size(), 2u);
    std::size_t i = 0;
    for (const Json& plane : json["planes"])
      for (const Json& corner : plane["hull"])
        EXPECT_LT ((drawing.points.at (i++) - moved * toVector (corner)).norm(), 1e-5);
    EXPECT_EQ (i, drawing.points.size());
  }
}

#ifdef PCL_OPS_WITH_SURFACE
TEST_F (Segment, CutsWindowsOutOfConcaveHulls)
{
  InputCloud wall; // 3 m by 2 m, with a window of 1 m by 0.8 m
  addGrid (wall, {0, 2, 0}, {0.02f, 0, 0}, 151, {0, 0, 0.02f}, 101);
  wall.erase (std::remove_if (wall.begin(),
                              wall.end(),
                              [] (const pcl::PointXYZI& point) {
                                return std::abs (point.x - 1.5f) < 0.495f &&
                                       std::abs (point.z - 1.2f) < 0.395f;
                              }),
              wall.end());
  save ("wall.pcd", wall);
  const Json plane = jsonOf ("wall.pcd --mesh m.ply --hull concave")["planes"][0];
  ASSERT_EQ (plane["holes"].size(), 1u);
  for (const Json& corner : plane["holes"][0])
    EXPECT_LT (std::abs (toVector (corner).x() - 1.5), 0.51);
  const auto [corners, faces] = readDrawing (contentOf (folder_ / "m.ply"));
  EXPECT_EQ (corners.size(), plane["hull"].size() + plane["holes"][0].size());
  double area = 0.0;
  for (const std::vector<double>& face : faces) {
    const Vector3d first = corners.at (std::size_t (face.at (1)));
    area += 0.5 * (corners.at (std::size_t (face.at (2))) - first)
                      .cross (corners.at (std::size_t (face.at (3))) - first)
                      .norm();
  }
  EXPECT_NEAR (area, plane["area"].get<double>(), 1e-3) << "no face in the window";
}
#endif

} // namespace
