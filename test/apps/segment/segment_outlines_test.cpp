// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "segment_program.h"

#include <cmath>
#include <iomanip>
#include <sstream>

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

/** \brief A ceiling of 2 m by 2 m, 100 m above the sensor, at UTM coordinates. */
std::string
ceilingText ()
{
  std::ostringstream text;
  text << std::fixed << std::setprecision (3);
  for (int i = 0; i < points_of_plane; ++i)
    text << 500000 + 0.04 * (i / points_of_side) << " "
         << 5400000 + 0.04 * (i % points_of_side) << " 100\n";
  return text.str();
}

} // namespace

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

TEST_F (Segment, WritesMillimetresOfUtmInPlainDecimals)
{
  folder_.write ("in.xyz", ceilingText());
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
  folder_.write ("in.xyz", ceilingText());
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
