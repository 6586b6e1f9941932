// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>

#include "segment_program.h"

#include <iomanip>
#include <map>
#include <sstream>
#include <utility>

namespace {

using SegmentEdges = Segment;
using Json = nlohmann::json;
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

} // namespace

TEST_F (SegmentEdges, WritesWherePlanesMeetToTheMillimetreFarFromZero)
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
  // Floor and wall of that cloud are one metre apart.
  for (const char* file : {"e.ply", "e.vtk", "e.json"})
    expectDone (std::string ("in.pcd --edges ") + file);
  EXPECT_TRUE (readPly (contentOf (folder_ / "e.ply")).vertices.empty());
  const auto json = jsonIn ("e.json");
  EXPECT_EQ (json, Json::parse (R"({"edges": [], "corners": []})"));
}
