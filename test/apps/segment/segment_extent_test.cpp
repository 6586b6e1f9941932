// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/io/ply_io.h>
#include <pcl/conversions.h>

#include <Eigen/Geometry>

#include "segment_program.h"

#include <cmath>
#include <sstream>
#include <utility>

namespace {

using Json = nlohmann::json;

constexpr double last_point = 2.0 * (points_of_side - 1) / points_of_side;

/** \brief The corners and faces of a legacy VTK file in text. */
std::pair<std::vector<Eigen::Vector3d>, std::size_t>
readVtk (const std::string& text)
{
  std::istringstream stream (text);
  std::vector<Eigen::Vector3d> corners;
  std::size_t faces = 0;
  for (std::string word; stream >> word;) {
    if (word == "POINTS") {
      std::size_t number = 0;
      stream >> number >> word;
      corners.resize (number);
      for (Eigen::Vector3d& corner : corners)
        stream >> corner.x() >> corner.y() >> corner.z();
    }
    else if (word == "POLYGONS")
      stream >> faces;
  }
  return {corners, faces};
}

/** \brief Three metres of a wall's lower part and a narrow tower on its left, an L. */
InputCloud
wallWithTower ()
{
  InputCloud cloud;
  for (int x = 0; x <= 150; ++x)
    for (int z = 0; z <= 100; ++z)
      if (z <= 40 || x <= 40)
        cloud.push_back (
            {0.02f * static_cast<float> (x), 2, 0.02f * static_cast<float> (z), 0});
  return cloud;
}

} // namespace

TEST_F (Segment, SaysWhereEachPlaneEnds)
{
  const auto json = jsonOf ("in.pcd --planes p.json");
  ASSERT_EQ (json["planes"].size(), 2u);
  for (const Json& plane : json["planes"]) {
    const Json& extent = plane["extent"];
    EXPECT_NEAR (plane["area"].get<double>(), last_point * last_point, 1e-5);
    EXPECT_NEAR (extent["length"].get<double>(), last_point, 1e-5);
    EXPECT_NEAR (extent["width"].get<double>(), last_point, 1e-5);
    EXPECT_TRUE (
        toVector (extent["center"]).isApprox (toVector (plane["centroid"]), 1e-5));
    EXPECT_TRUE (toVector (extent["axes"][0])
                     .cross (toVector (extent["axes"][1]))
                     .isApprox (toVector (plane["normal"]), 1e-9));
    ASSERT_GE (plane["hull"].size(), 4u);
    for (const Json& corner : plane["hull"])
      EXPECT_NEAR (
          (toVector (corner) - toVector (plane["centroid"])).lpNorm<Eigen::Infinity>(),
          0.5 * last_point,
          1e-5);
  }
}

TEST_F (Segment, SaysWherePlanesFarAwayEnd)
{
  std::ostringstream text;
  text.precision (12);
  text << "FIELDS x y z\nSIZE 8 8 8\nTYPE F F F\nWIDTH 2601\nHEIGHT 1\nPOINTS 2601\n"
       << "DATA ascii\n";
  for (int x = 0; x <= 50; ++x)
    for (int y = 0; y <= 50; ++y)
      text << 1e6 + 0.02 * x << " " << -1e6 + 0.01 * y << " 1e6\n";
  folder_.write ("far.pcd", text.str());
  const auto json = jsonOf ("far.pcd --planes p.json");
  ASSERT_EQ (json["planes"].size(), 1u);
  EXPECT_NEAR (json["planes"][0]["area"].get<double>(), 0.5, 0.005);
  EXPECT_LT ((toVector (json["planes"][0]["extent"]["center"]) -
              Eigen::Vector3d (1000000.5, -999999.75, 1e6))
                 .norm(),
             1e-3);
}

TEST_F (Segment, WritesHullsAsAMeshInTheColorsOfTheLabels)
{
  const LabelledCloud cloud = label ("in.pcd", "--mesh m.ply --planes p.json");
  pcl::PolygonMesh mesh;
  ASSERT_EQ (pcl::io::loadPLYFile (folder_ / "m.ply", mesh), 0);
  pcl::PointCloud<pcl::PointXYZRGB> corners;
  pcl::fromPCLPointCloud2 (mesh.cloud, corners);
  const auto json = jsonIn ("p.json");
  const std::size_t of_first = json["planes"][0]["hull"].size();
  ASSERT_EQ (corners.size(), of_first + json["planes"][1]["hull"].size());
  EXPECT_GE (mesh.polygons.size(), 2u);
  std::size_t corner = 0;
  for (const Json& plane : json["planes"])
    for (const Json& place : plane["hull"]) {
      EXPECT_LT (
          (corners[corner].getVector3fMap().cast<double>() - toVector (place)).norm(),
          1e-5);
      ++corner;
    }
  const auto labels = labelsOf (cloud);
  const std::size_t floor = labels[0] == 1 ? 0 : of_first;
  EXPECT_EQ (corners[floor].rgba & 0xffffff, cloud[0].rgba & 0xffffff);
}

TEST_F (Segment, WritesAMeshThatLiesOnTheCloudInPclViewer)
{
  // pcl_viewer moves a cloud by the pose of its sensor, and a mesh by nothing.
  InputCloud posed = floorAndWall();
  posed.sensor_orientation_ = Eigen::AngleAxisf (0.5f, Eigen::Vector3f::UnitY());
  pcl::io::savePCDFileBinary (folder_ / "posed.pcd", posed);
  expectDone ("posed.pcd --mesh m.vtk --planes p.json");
  const Eigen::Affine3d pose =
      Eigen::Translation3d (posed.sensor_origin_.head<3>().cast<double>()) *
      posed.sensor_orientation_.cast<double>();
  const auto [corners, faces] = readVtk (contentOf (folder_ / "m.vtk"));
  const auto json = jsonIn ("p.json");
  EXPECT_GE (faces, 2u);
  std::size_t corner = 0;
  for (const Json& plane : json["planes"])
    for (const Json& place : plane["hull"]) {
      ASSERT_LT (corner, corners.size());
      EXPECT_LT ((corners[corner] - pose * toVector (place)).norm(), 1e-5);
      ++corner;
    }
}

TEST_F (Segment, DrawsConcaveHullsOrSaysHowToGetThem)
{
  pcl::io::savePCDFileBinary (folder_ / "l.pcd", wallWithTower());
  const Outcome done = run ("l.pcd --planes p.json --mesh m.ply --hull concave");
#ifdef PCL_OPS_WITH_SURFACE
  constexpr double area = 3.0 * 0.8 + 0.8 * 1.2;
  ASSERT_EQ (done.exit_code, 0) << done.err;
  EXPECT_EQ (done.err, "");
  const auto json = jsonIn ("p.json");
  EXPECT_NEAR (json["planes"][0]["area"].get<double>(), area, 0.02 * area);
  EXPECT_NEAR (json["planes"][0]["extent"]["length"].get<double>(), 3.0, 0.1);
  pcl::PolygonMesh mesh;
  ASSERT_EQ (pcl::io::loadPLYFile (folder_ / "m.ply", mesh), 0);
  EXPECT_GE (mesh.polygons.size(), 4u) << "an L takes four triangles or more";
#else
  EXPECT_EQ (done.exit_code, 2);
  EXPECT_TRUE (contains (done.err, "--hull: concave is not in this build"));
#endif
}

#ifdef PCL_OPS_WITH_SURFACE
TEST_F (Segment, CutsWindowsOutOfConcaveHulls)
{
  InputCloud wall; // 3 m by 2 m, with a window of 1 m by 0.8 m
  for (int x = 0; x <= 150; ++x)
    for (int z = 0; z <= 100; ++z)
      if (!(x > 50 && x < 100 && z > 40 && z < 80))
        wall.push_back (
            {0.02f * static_cast<float> (x), 2, 0.02f * static_cast<float> (z), 0});
  pcl::io::savePCDFileBinary (folder_ / "wall.pcd", wall);
  expectDone ("wall.pcd --planes p.json --mesh m.ply --hull concave");
  const auto map = jsonOf ("wall.pcd --planes p.geojson --hull concave", "p.geojson");
  EXPECT_EQ (map["features"][0]["geometry"]["coordinates"].size(), 2u);
  const auto plane = jsonIn ("p.json")["planes"][0];
  EXPECT_NEAR (plane["area"].get<double>(), 6.0 - 0.8, 0.06);
  ASSERT_EQ (plane["holes"].size(), 1u);
  for (const Json& corner : plane["holes"][0])
    EXPECT_LT ((toVector (corner) - Eigen::Vector3d (1.5, 2, 1.2)).cwiseAbs().x(),
               0.51);
  pcl::PolygonMesh mesh;
  ASSERT_EQ (pcl::io::loadPLYFile (folder_ / "m.ply", mesh), 0);
  pcl::PointCloud<pcl::PointXYZ> corners;
  pcl::fromPCLPointCloud2 (mesh.cloud, corners);
  EXPECT_EQ (corners.size(), plane["hull"].size() + plane["holes"][0].size());
  double area = 0.0;
  for (const pcl::Vertices& face : mesh.polygons) {
    const auto place = [&] (std::size_t corner) {
      return corners[static_cast<std::size_t> (face.vertices[corner])].getVector3fMap();
    };
    area += 0.5 * (place (1) - place (0)).cross (place (2) - place (0)).norm();
  }
  EXPECT_NEAR (area, plane["area"].get<double>(), 1e-3) << "no face in the window";

  const auto convex = jsonOf ("wall.pcd --planes p.json")["planes"][0];
  EXPECT_TRUE (convex["holes"].empty());
  EXPECT_NEAR (convex["area"].get<double>(), 6.0, 0.06);
}
#endif

TEST_F (Segment, WritesAnEmptyMeshWhereThereIsNoPlane)
{
  InputCloud line;
  for (int i = 0; i < 100; ++i)
    line.push_back ({static_cast<float> (i), 0, 0, 0});
  pcl::io::savePCDFileBinary (folder_ / "line.pcd", line);
  for (const char* mesh : {"m.ply", "m.vtk"}) {
    const Outcome done = expectDone (std::string ("line.pcd --mesh ") + mesh);
    EXPECT_EQ (done.err, "");
  }
  pcl::PolygonMesh mesh;
  pcl::io::loadPLYFile (folder_ / "m.ply", mesh);
  EXPECT_TRUE (mesh.polygons.empty());
  EXPECT_TRUE (readVtk (contentOf (folder_ / "m.vtk")).first.empty());
}
