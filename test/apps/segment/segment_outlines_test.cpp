// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/io/ply_io.h>
#include <pcl/conversions.h>

#include <Eigen/Geometry>

#include "segment_program.h"

#include <cmath>
#include <iomanip>
#include <map>
#include <sstream>
#include <utility>

namespace {

using Json = nlohmann::json;

/** \brief Twice the area of a closed ring as seen from above. */
double
signedArea (const Json& ring)
{
  double area = 0.0;
  for (std::size_t i = 0; i + 1 < ring.size(); ++i)
    area += (ring[i][0].get<double>() - ring[0][0].get<double>()) *
                (ring[i + 1][1].get<double>() - ring[0][1].get<double>()) -
            (ring[i + 1][0].get<double>() - ring[0][0].get<double>()) *
                (ring[i][1].get<double>() - ring[0][1].get<double>());
  return area;
}

TEST_F (Segment, WritesOutlinesAsGeoJson)
{
  expectDone ("in.pcd --planes p.geojson");
  const Json map = jsonOf ("in.pcd --planes p.json", "p.geojson");
  const Json planes = jsonIn ("p.json")["planes"];
  EXPECT_EQ (map["type"], "FeatureCollection");
  ASSERT_EQ (map["features"].size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    const Json& feature = map["features"][i];
    EXPECT_EQ (feature["type"], "Feature");
    EXPECT_EQ (feature["id"], i + 1);
    EXPECT_EQ (feature["geometry"]["type"], "Polygon");
    const Json& rings = feature["geometry"]["coordinates"];
    ASSERT_EQ (rings.size(), 1u);
    EXPECT_EQ (rings[0].size(), planes[i]["hull"].size() + 1);
    EXPECT_EQ (rings[0].front(), rings[0].back()) << "RFC 7946, 3.1.6: closed";
    EXPECT_GE (signedArea (rings[0]), -1e-9) << "RFC 7946, 3.1.6: counterclockwise";
    for (const Json& corner : rings[0])
      EXPECT_EQ (corner.size(), 3u);
    const Json& properties = feature["properties"];
    for (const char* key :
         {"id", "orientation", "points", "rms", "area", "slope", "aspect", "height"})
      EXPECT_EQ (properties[key], planes[i][key]) << key;
    EXPECT_EQ (properties["width"], planes[i]["extent"]["width"]);
    EXPECT_EQ (properties["nx"], planes[i]["normal"][0]);
    EXPECT_EQ (properties["d"], planes[i]["coefficients"][3]);
    for (const Json& value : properties)
      EXPECT_FALSE (value.is_structured()) << "GDAL's formats have no lists: " << value;
  }
}

TEST_F (Segment, WritesOutlinesOfCeilingsCounterClockwiseFromAboveToo)
{
  InputCloud ceiling = floorAndWall();
  ceiling.sensor_origin_.z() = -2.0f;
  pcl::io::savePCDFileBinary (folder_ / "in.pcd", ceiling);
  const Json map = jsonOf ("in.pcd --only horizontal --planes p.geojson", "p.geojson");
  ASSERT_EQ (map["features"].size(), 1u);
  const Json& feature = map["features"][0];
  EXPECT_LT (feature["properties"]["nz"].get<double>(), 0.0);
  EXPECT_NEAR (signedArea (feature["geometry"]["coordinates"][0]),
               2 * feature["properties"]["area"].get<double>(),
               1e-2);
}

TEST_F (Segment, WritesMillimetersOfUtmInPlainDecimals)
{
  folder_.write ("in.xyz", squareText (points_of_side, 100.0));
  expectDone ("in.xyz --planes p.geojson");
  expectDone ("in.xyz --planes p.csv");
  EXPECT_TRUE (
      contains (contentOf (folder_ / "p.geojson"), "[500000.000,5400000.000,100.000]"));
  EXPECT_TRUE (
      contains (contentOf (folder_ / "p.csv"), "500000.000 5400000.000 100.000,"));
}

TEST_F (Segment, WritesOutlinesInTheCsvAsWkt)
{
  expectDone ("in.pcd --planes p.csv");
  std::istringstream csv (contentOf (folder_ / "p.csv"));
  std::string line;
  std::getline (csv, line);
  EXPECT_EQ (
      line,
      "id,orientation,points,a,b,c,d,centroid_x,centroid_y,centroid_z,"
      "normal_x,normal_y,normal_z,rms,area,length,width,slope,aspect,height,wkt");
  for (int plane = 0; plane < 2; ++plane) {
    std::getline (csv, line);
    const std::size_t begin = line.find (",\"POLYGON Z ((");
    ASSERT_NE (begin, std::string::npos) << line;
    EXPECT_EQ (std::count (line.begin(), line.begin() + long (begin), ','), 19);
    const std::string outline = line.substr (begin + 14, line.size() - begin - 17);
    EXPECT_EQ (line.substr (line.size() - 3), "))\"");
    EXPECT_EQ (outline.substr (0, outline.find (',')),
               outline.substr (outline.rfind (',') + 1))
        << "closed";
  }
}

TEST_F (Segment, TurnsPlanesOfCloudsWithoutASensorUp)
{
  folder_.write ("in.xyz", squareText (points_of_side, 100.0));
  const Json plane = jsonOf ("in.xyz --planes p.json")["planes"].at (0);
  EXPECT_GT (plane["normal"][2].get<double>(), 0.99);
  EXPECT_NEAR (plane["height"].get<double>(), 100.0, 1e-3);
  EXPECT_NEAR (plane["slope"].get<double>(), 0.0, 0.01);
}

TEST_F (Segment, SaysWhereASlopeGoesDown)
{
  const std::pair<const char*, double> rises[] = {
      {"-y", 0.0}, {"-x", 90.0}, {"y", 180.0}, {"x", 270.0}};
  for (const auto& [direction, aspect] : rises) {
    std::ostringstream text;
    for (int i = 0; i < points_of_plane; ++i) {
      const double x = 0.04 * (i / points_of_side), y = 0.04 * (i % points_of_side);
      const std::string rise = direction;
      const double along = rise.back() == 'x' ? x : y;
      text << x << " " << y << " " << (rise.size() > 1 ? 2 - along : along) << "\n";
    }
    folder_.write ("slope.xyz", text.str());
    const Json plane = jsonOf ("slope.xyz --planes p.json")["planes"].at (0);
    EXPECT_NEAR (plane["slope"].get<double>(), 45.0, 0.1) << direction;
    const double turn = plane["aspect"].get<double>() - aspect;
    EXPECT_NEAR (std::remainder (turn, 360.0), 0.0, 0.1) << direction;
  }
}

TEST_F (Segment, NamesTheReferenceSystemAndSimplifies)
{
  const Json map = jsonOf ("in.pcd --planes p.geojson --crs EPSG:25832 --simplify 0.05",
                           "p.geojson");
  EXPECT_EQ (map["crs"]["properties"]["name"], "urn:ogc:def:crs:EPSG::25832");
  EXPECT_EQ (map["features"][0]["geometry"]["coordinates"][0].size(), 5u);
}

TEST_F (Segment, WritesAnEmptyMapOfNoPlanes)
{
  folder_.write ("few.xyz", "1 2 3\n4 5 6\n");
  const Json map = jsonOf ("few.xyz --planes p.geojson", "p.geojson");
  EXPECT_EQ (map["features"], Json::array());
}

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

#ifndef PCL_OPS_WITH_SURFACE
TEST_F (Segment, SaysHowToGetConcaveHulls)
{
  expectRefused (
      "in.pcd --mesh m.ply --hull concave", "--hull: concave is not in this build", 2);
}
#else
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

using SegmentEdges = Segment;
using Eigen::Vector3d;

/** \brief Floor and two walls of 2 m by 2 m, which meet at \p corner, in text with
 * double precision. */
std::string
cornerAt (const Vector3d& corner)
{
  std::vector<Vector3d> points;
  for (int i = 0; i < points_of_side; ++i)
    for (int j = 0; j < points_of_side; ++j) {
      const double s = (i + 0.5) * 2.0 / points_of_side;
      const double t = (j + 0.5) * 2.0 / points_of_side;
      for (const Vector3d& place : {Vector3d (s, t, 0), {0, s, t}, {t, 0, s}})
        points.push_back (corner + place);
    }
  std::ostringstream text;
  text << "FIELDS x y z\nSIZE 8 8 8\nTYPE F F F\nWIDTH " << points.size()
       << "\nHEIGHT 1\nPOINTS " << points.size() << "\nDATA ascii\n"
       << std::setprecision (16);
  for (const Vector3d& point : points)
    text << point.x() << " " << point.y() << " " << point.z() << "\n";
  return text.str();
}

/** \brief A .ply with vertices and edges, as others read it. */
struct Wires {
  std::vector<Vector3d> vertices;
  std::vector<std::array<int, 4>> edges; // two vertices, two planes
};

Wires
readPly (const std::string& text)
{
  std::istringstream stream (text);
  std::map<std::string, std::size_t> elements;
  std::string line;
  while (std::getline (stream, line) && line != "end_header") {
    std::istringstream words (line);
    std::string word, name;
    std::size_t number = 0;
    if (words >> word >> name >> number && word == "element")
      elements[name] = number;
  }
  EXPECT_EQ (line, "end_header");
  Wires wires;
  wires.vertices.resize (elements["vertex"]);
  for (Vector3d& vertex : wires.vertices)
    stream >> vertex.x() >> vertex.y() >> vertex.z();
  wires.edges.resize (elements["edge"]);
  for (auto& edge : wires.edges)
    for (int& number : edge)
      stream >> number;
  EXPECT_TRUE (stream) << text;
  EXPECT_FALSE (stream >> line) << "more than the header says: " << line;
  return wires;
}

const Vector3d far_away (448261.25, 5411932.5, 312.125);

TEST_F (SegmentEdges, WritesWherePlanesMeetToTheMillimeterFarFromZero)
{
  folder_.write ("far.pcd", cornerAt (far_away));
  const Outcome done = expectDone ("far.pcd --edges e.json");
  EXPECT_EQ (done.err, "");
  const auto json = jsonIn ("e.json");
  ASSERT_EQ (json["edges"].size(), 3u);
  ASSERT_EQ (json["corners"].size(), 1u);
  EXPECT_LT ((toVector (json["corners"][0]["position"]) - far_away).norm(), 1e-3);
  EXPECT_EQ (json["corners"][0]["planes"], Json ({1, 2, 3}));
  for (const Json& edge : json["edges"]) {
    const Vector3d from = toVector (edge["from"]);
    const Vector3d to = toVector (edge["to"]);
    EXPECT_NEAR (edge["angle"].get<double>(), 90.0, 0.01);
    EXPECT_NEAR (edge["length"].get<double>(), (to - from).norm(), 1e-6);
    EXPECT_NEAR ((to - from).norm(), 2.0, 0.1);
    EXPECT_LT (std::min ((from - far_away).norm(), (to - far_away).norm()), 1e-3);
  }
}

TEST_F (SegmentEdges, WritesEdgesAsAPlyOfWiresThatShareTheirCorner)
{
  folder_.write ("far.pcd", cornerAt (far_away));
  expectDone ("far.pcd --edges e.ply");
  const Wires wires = readPly (contentOf (folder_ / "e.ply"));
  ASSERT_EQ (wires.edges.size(), 3u);
  EXPECT_EQ (wires.vertices.size(), 4u);
  EXPECT_LT ((wires.vertices[0] - far_away).norm(), 1e-3);
  std::set<std::pair<int, int>> planes;
  for (const auto& [from, to, first, second] : wires.edges) {
    EXPECT_EQ (std::min (from, to), 0) << "the corner";
    planes.emplace (first, second);
  }
  EXPECT_EQ (planes, (std::set<std::pair<int, int>>{{1, 2}, {1, 3}, {2, 3}}));
}

TEST_F (SegmentEdges, WritesEdgesThatLieOnTheCloudInPclViewer)
{
  folder_.write ("near.pcd", cornerAt ({1, 2, 3}));
  expectDone ("near.pcd --edges e.vtk --quiet");
  const std::string text = contentOf (folder_ / "e.vtk");
  EXPECT_TRUE (contains (text, "POINTS 4 double\n"));
  EXPECT_TRUE (contains (text, "VERTICES 1 2\n1 0\n"));
  EXPECT_TRUE (contains (text, "LINES 3 9\n"));
}

TEST_F (SegmentEdges, WritesNoEdgeWhereNoPlanesMeet)
{
  // Floor and wall of that cloud are one meter apart.
  for (const char* file : {"e.ply", "e.vtk", "e.json"})
    expectDone (std::string ("in.pcd --edges ") + file);
  EXPECT_TRUE (readPly (contentOf (folder_ / "e.ply")).vertices.empty());
  const auto json = jsonIn ("e.json");
  EXPECT_EQ (json, Json::parse (R"({"edges": [], "corners": []})"));
}

} // namespace
