// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/io/ply_io.h>
#include <pcl/conversions.h>

#include <Eigen/Geometry>

#include "segment_program.h"

#include <array>
#include <cmath>
#include <iomanip>
#include <map>
#include <sstream>
#include <utility>

namespace {

using Eigen::Vector3d;
using Json = nlohmann::json;

/** \brief Twice the area of a closed ring as seen from above. */
double
signedArea (const Json& ring)
{
  const Vector3d first = toVector (ring[0]);
  double area = 0.0;
  for (std::size_t i = 0; i + 1 < ring.size(); ++i)
    area += (toVector (ring[i]) - first).cross (toVector (ring[i + 1]) - first).z();
  return area;
}

TEST_F (Segment, WritesOutlinesAsGeoJson)
{
  expectDone ("in.pcd --planes p.geojson");
  const Json map = jsonIn ("p.geojson"), planes = jsonOf ("in.pcd")["planes"];
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

TEST_F (Segment, WritesOutlinesOfFloorsAndCeilingsCounterClockwiseFromAbove)
{
  InputCloud room = floorAndWall();
  for (const float height : {1.5f, -2.0f}) {
    room.sensor_origin_.z() = height;
    save ("in.pcd", room);
    expectDone ("in.pcd --only horizontal --planes p.geojson");
    const Json feature = jsonIn ("p.geojson")["features"].at (0);
    EXPECT_EQ (feature["properties"]["nz"].get<double>() > 0.0, height > 0.0f);
    EXPECT_NEAR (signedArea (feature["geometry"]["coordinates"][0]),
                 2 * feature["properties"]["area"].get<double>(),
                 1e-2)
        << "RFC 7946, 3.1.6";
  }
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
    EXPECT_EQ (line.substr (line.size() - 3), "))\"");
  }
}

TEST_F (Segment, TurnsPlanesOfCloudsWithoutASensorUp)
{
  folder_.write ("in.xyz", squareText (points_of_side, 100.0));
  const Json plane = jsonOf ("in.xyz")["planes"].at (0);
  EXPECT_GT (plane["normal"][2].get<double>(), 0.99);
  EXPECT_NEAR (plane["height"].get<double>(), 100.0, 1e-3);
  EXPECT_NEAR (plane["slope"].get<double>(), 0.0, 0.01);
}

TEST_F (Segment, SaysWhereASlopeGoesDown)
{
  const std::tuple<float, float, double> rows[] = {
      {0, -1, 0.0}, {-1, 0, 90.0}, {0, 1, 180.0}, {1, 0, 270.0}};
  for (const auto& [rise_x, rise_y, aspect] : rows) {
    InputCloud slope;
    constexpr float step = 0.04f;
    addGrid (
        slope, {0, 0, 3}, {step, 0, step * rise_x}, 50, {0, step, step * rise_y}, 50);
    save ("slope.pcd", slope);
    const Json plane = jsonOf ("slope.pcd")["planes"].at (0);
    EXPECT_NEAR (plane["slope"].get<double>(), 45.0, 0.1) << aspect;
    const double turn = plane["aspect"].get<double>() - aspect;
    EXPECT_NEAR (std::remainder (turn, 360.0), 0.0, 0.1) << aspect;
  }
}

TEST_F (Segment, NamesTheReferenceSystemAndSimplifies)
{
  expectDone ("in.pcd --planes p.geojson --crs EPSG:25832 --simplify 0.05");
  const Json map = jsonIn ("p.geojson");
  EXPECT_EQ (map["crs"]["properties"]["name"], "urn:ogc:def:crs:EPSG::25832");
  EXPECT_EQ (map["features"][0]["geometry"]["coordinates"][0].size(), 5u);
}

/** \brief A .ply or .vtk in text, as others read it. */
struct Drawing {
  std::vector<Vector3d> points;
  /** \brief The numbers of each face or edge. */
  std::vector<std::vector<int>> cells;
};

Drawing
readDrawing (const std::string& text)
{
  // A .vtk goes on with the colors.
  std::istringstream stream (text.substr (0, text.find ("POINT_DATA")));
  std::map<std::string, std::size_t> counts;
  Drawing drawing;
  for (std::string line; std::getline (stream, line);) {
    std::istringstream words (line);
    std::string word, name;
    words >> word;
    if (word == "element" && words >> name)
      words >> counts[name];
    else if (word == "POINTS")
      words >> counts[word];
    std::istringstream numbers (line);
    double first = 0;
    if (!(numbers >> first))
      continue;
    if (drawing.points.size() < counts["vertex"] + counts["POINTS"]) {
      drawing.points.emplace_back (first, 0, 0);
      numbers >> drawing.points.back().y() >> drawing.points.back().z();
    }
    else {
      drawing.cells.push_back ({static_cast<int> (first)});
      for (int number = 0; numbers >> number;)
        drawing.cells.back().push_back (number);
    }
  }
  return drawing;
}

/** \brief Whether the points of a mesh are the corners of planes, moved. */
void
expectHulls (const std::vector<Vector3d>& points,
             const Json& planes,
             const Eigen::Isometry3d& pose)
{
  std::size_t i = 0;
  for (const Json& plane : planes)
    for (const Json& corner : plane["hull"])
      EXPECT_LT ((points.at (i++) - pose * toVector (corner)).norm(), 1e-5);
  EXPECT_EQ (i, points.size());
}

TEST_F (Segment, WritesHullsAsAMeshInTheColorsOfTheLabels)
{
  const LabelledCloud cloud = label ("in.pcd", "--mesh m.ply --planes p.json");
  const Json planes = jsonIn ("p.json")["planes"];
  const Drawing mesh = readDrawing (contentOf (folder_ / "m.ply"));
  expectHulls (mesh.points, planes, Eigen::Isometry3d::Identity());
  EXPECT_GE (mesh.cells.size(), 2u);
  pcl::PointCloud<pcl::PointXYZRGB> corners;
  ASSERT_EQ (pcl::io::loadPLYFile (folder_ / "m.ply", corners), 0);
  const std::size_t floor = cloud[0].label == 1 ? 0 : planes[0]["hull"].size();
  EXPECT_EQ (corners[floor].rgba & 0xffffff, cloud[0].rgba & 0xffffff);
}

TEST_F (Segment, WritesAMeshThatLiesOnTheCloudInPclViewer)
{
  // pcl_viewer moves a cloud by the pose of its sensor, and a mesh by nothing.
  InputCloud posed = floorAndWall();
  posed.sensor_orientation_ = Eigen::AngleAxisf (0.5f, Eigen::Vector3f::UnitY());
  save ("posed.pcd", posed);
  const Json planes = jsonOf ("posed.pcd --mesh m.vtk")["planes"];
  const Drawing mesh = readDrawing (contentOf (folder_ / "m.vtk"));
  expectHulls (mesh.points,
               planes,
               Eigen::Translation3d (posed.sensor_origin_.head<3>().cast<double>()) *
                   posed.sensor_orientation_.cast<double>());
  EXPECT_GE (mesh.cells.size(), 2u);
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
  EXPECT_NEAR (plane["area"].get<double>(), 6.0 - 0.8, 0.06);
  ASSERT_EQ (plane["holes"].size(), 1u);
  for (const Json& corner : plane["holes"][0])
    EXPECT_LT (std::abs (toVector (corner).x() - 1.5), 0.51);
  const auto [corners, faces] = readDrawing (contentOf (folder_ / "m.ply"));
  EXPECT_EQ (corners.size(), plane["hull"].size() + plane["holes"][0].size());
  double area = 0.0;
  for (const std::vector<int>& face : faces) {
    const Vector3d first = corners.at (std::size_t (face.at (1)));
    area += 0.5 * (corners.at (std::size_t (face.at (2))) - first)
                      .cross (corners.at (std::size_t (face.at (3))) - first)
                      .norm();
  }
  EXPECT_NEAR (area, plane["area"].get<double>(), 1e-3) << "no face in the window";
  expectDone ("wall.pcd --planes p.geojson --hull concave");
  EXPECT_EQ (jsonIn ("p.geojson")["features"][0]["geometry"]["coordinates"].size(), 2u);
  const Json convex = jsonOf ("wall.pcd")["planes"][0];
  EXPECT_TRUE (convex["holes"].empty());
  EXPECT_NEAR (convex["area"].get<double>(), 6.0, 0.06);
  const std::string large = "wall.pcd --min-area 5.5 --hull ";
  EXPECT_EQ (jsonOf (large + "convex")["planes"].size(), 1u);
  EXPECT_EQ (jsonOf (large + "concave")["planes"].size(), 0u);
}
#endif

/** \brief The program with far.pcd: floor and two walls of 2 m by 2 m, which meet far
 * from zero, in text with double precision. */
class SegmentEdges : public Segment {
protected:
  SegmentEdges()
  {
    std::ostringstream text;
    text << std::setprecision (16)
         << "FIELDS x y z\nSIZE 8 8 8\nTYPE F F F\nWIDTH 7500\nHEIGHT 1\n"
            "POINTS 7500\nDATA ascii\n";
    for (int i = 0; i < points_of_plane; ++i) {
      const double s = (i / points_of_side + 0.5) * 2.0 / points_of_side;
      const double t = (i % points_of_side + 0.5) * 2.0 / points_of_side;
      for (const Vector3d& place : {Vector3d (s, t, 0), {0, s, t}, {t, 0, s}})
        text << (corner_ + place).transpose() << "\n";
    }
    folder_.write ("far.pcd", text.str());
  }

  const Vector3d corner_{448261.25, 5411932.5, 312.125};
};

TEST_F (SegmentEdges, WritesWherePlanesMeetToTheMillimeterFarFromZero)
{
  EXPECT_EQ (expectDone ("far.pcd --edges e.json").err, "");
  const Json json = jsonIn ("e.json");
  ASSERT_EQ (json["edges"].size(), 3u);
  ASSERT_EQ (json["corners"].size(), 1u);
  EXPECT_LT ((toVector (json["corners"][0]["position"]) - corner_).norm(), 1e-3);
  EXPECT_EQ (json["corners"][0]["planes"], Json ({1, 2, 3}));
  for (const Json& edge : json["edges"]) {
    const Vector3d from = toVector (edge["from"]), to = toVector (edge["to"]);
    EXPECT_NEAR (edge["angle"].get<double>(), 90.0, 0.01);
    EXPECT_NEAR (edge["length"].get<double>(), (to - from).norm(), 1e-6);
    EXPECT_NEAR ((to - from).norm(), 2.0, 0.1);
    EXPECT_LT (std::min ((from - corner_).norm(), (to - corner_).norm()), 1e-3);
  }
}

TEST_F (SegmentEdges, WritesEdgesAsWiresThatShareTheirCorner)
{
  expectDone ("far.pcd --edges e.ply");
  const Drawing wires = readDrawing (contentOf (folder_ / "e.ply"));
  ASSERT_EQ (wires.cells.size(), 3u);
  ASSERT_EQ (wires.points.size(), 4u);
  EXPECT_LT ((wires.points[0] - corner_).norm(), 1e-3);
  std::set<std::pair<int, int>> planes;
  for (const std::vector<int>& edge : wires.cells) {
    EXPECT_EQ (std::min (edge.at (0), edge.at (1)), 0) << "the corner";
    planes.emplace (edge.at (2), edge.at (3));
  }
  EXPECT_EQ (planes, (std::set<std::pair<int, int>>{{1, 2}, {1, 3}, {2, 3}}));
  expectDone ("far.pcd --edges e.vtk --quiet");
  const std::string text = contentOf (folder_ / "e.vtk");
  for (const char* part : {"POINTS 4 double\n", "VERTICES 1 2\n1 0\n", "LINES 3 9\n"})
    EXPECT_TRUE (contains (text, part));
  // Floor and wall of that cloud are one meter apart.
  expectDone ("in.pcd --edges e.ply");
  EXPECT_TRUE (contains (contentOf (folder_ / "e.ply"), "element vertex 0\n"));
}

} // namespace
