// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <boost/algorithm/string/replace.hpp>

#include <detection/advice.h>
#include <detection/plane_list.h>

#include <algorithm>
#include <limits>

using namespace pcl_ops;
using namespace pcl_ops::apps;

namespace {

/** \brief What a list says of a plane with this outline and these parts beside it,
 * where the other plane is 5 m wide. */
struct Written {
  std::string wkt, json;

  explicit Written (const PlaneExtent& extent,
                    const Polygons& parts = {},
                    double simplify = 0.0)
  {
    const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
    PlaneExtent other;
    other.width = 5.0;
    const nlohmann::ordered_json list = {
        {"planes",
         nlohmann::ordered_json::array (
             {planeObject (1, {}, extent, up, parts), planeObject (2, {}, other)})}};
    const std::string csv = planesFor ("a.csv", list, {"", simplify});
    const std::size_t begin = csv.find ('"') + 1;
    wkt = csv.substr (begin, csv.find ('"', begin) - begin);
    const std::string text = planesFor ("a.geojson", list, {"", simplify});
    json = nlohmann::json::parse (text)["features"][0]["geometry"].dump();
  }
};

PlaneExtent
extentOf (const Ring& hull, const Rings& holes = {}, double width = 0.0)
{
  PlaneExtent extent;
  extent.hull = hull;
  extent.holes = holes;
  extent.width = width;
  return extent;
}

} // namespace

TEST (Outlines, AreClosedWithTheirHolesAndPartsAndCounterClockwiseSeenFromAbove)
{
  const Ring hull = {{0, 0, 1}, {4, 0, 1}, {0, 4, 1}},
             clockwise = {hull.rbegin(), hull.rend()};
  const Ring hole = {{1, 1, 1}, {1, 2, 1}, {2, 1, 1}},
             turned = {hole.rbegin(), hole.rend()};
  const Rings part = {{{5, 5, 1}, {6, 5, 1}, {6, 6, 1}}};
  const std::string first_wkt = "((0 0 1,4 0 1,0 4 1,0 0 1),(1 1 1,1 2 1,2 1 1,1 1 1))";
  const std::string first_json =
      "[[[0,0,1],[4,0,1],[0,4,1],[0,0,1]],[[1,1,1],[1,2,1],[2,1,1],[1,1,1]]]";
  const struct {
    PlaneExtent extent;
    Polygons parts;
    std::string wkt, json;
  } rows[] = {{{}, {}, "POLYGON Z EMPTY", "null"},
              {extentOf (clockwise, {turned}),
               {},
               "POLYGON Z " + first_wkt,
               R"({"coordinates":)" + first_json + R"(,"type":"Polygon"})"},
              {extentOf (hull, {hole}),
               {part},
               "MULTIPOLYGON Z (" + first_wkt + ",((5 5 1,6 5 1,6 6 1,5 5 1)))",
               R"({"coordinates":[)" + first_json +
                   R"(,[[[5,5,1],[6,5,1],[6,6,1],[5,5,1]]]],"type":"MultiPolygon"})"}};
  for (const auto& row : rows) {
    const Written written (row.extent, row.parts);
    EXPECT_EQ (boost::replace_all_copy (written.wkt, ".000", ""), row.wkt);
    EXPECT_EQ (boost::replace_all_copy (written.json, ".0", ""), row.json);
  }
}

TEST (Outlines, LoseCornersNearAStraightLine)
{
  const Ring jagged = {{0, 0.1, 0},
                       {2, 0, 0},
                       {4, 0.1, 0},
                       {6, 0, 0},
                       {6.1, 2, 0},
                       {6, 4, 0},
                       {3, 3.9, 0},
                       {0, 4, 0},
                       {0.1, 2, 0}};
  const Ring narrow = {{1, 1, 0}, {1, 2, 0}, {1.1, 1, 0}};
  const auto corners = [] (const Written& written) {
    return std::count (written.wkt.begin(), written.wkt.end(), ',');
  };
  EXPECT_EQ (corners (Written (extentOf (jagged, {narrow}))), 9 + 1 + 3);
  EXPECT_EQ (corners (Written (extentOf (jagged, {narrow}), {}, 0.3)), 4)
      << "the hole has no area left";
  EXPECT_EQ (corners (Written (extentOf (narrow), {}, 9.0)), 3)
      << "an outline stays one";
}

TEST (Outlines, HaveMillimetersFarFromZeroAndDecimalsForTheNarrowestPlane)
{
  const Ring point = {{5400000.1234, 1e-7, -1e-7}};
  const std::pair<double, int> rows[] = {{0.0, 3}, {5000.0, 3}, {0.04, 5}, {1e-30, 12}};
  EXPECT_EQ (Written (extentOf (point)).wkt,
             "POLYGON Z ((5400000.123 0.000 0.000,5400000.123 0.000 0.000))");
  for (const auto& [width, decimals] : rows) {
    const std::string wkt = Written (extentOf (point, {}, width)).wkt;
    EXPECT_EQ (wkt.find (' ', wkt.find ('.')) - wkt.find ('.') - 1, decimals) << wkt;
  }
}

TEST (Advice, IsGivenWherePlanesHaveLessThanATwentiethOfTheReadings)
{
  constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();
  const OrientedPointSamplingParameters ops;
  XyzCloud cloud;
  for (int i = 0; i < 100; ++i) {
    cloud.emplace_back (static_cast<float> (i), 0.0f, 0.0f);
    cloud.emplace_back (not_a_number, not_a_number, not_a_number);
  }
  for (const auto& [inliers, is_hardly_covered] :
       {std::pair (0, true), std::pair (4, true), std::pair (5, false)}) {
    PlaneSegment plane;
    plane.inliers.resize (inliers);
    EXPECT_NE (adviceFor (ops, cloud, {plane}).empty(), is_hardly_covered) << inliers;
  }
  EXPECT_EQ (adviceFor (ops, {}, {}), "every point is NaN or infinite");
}
