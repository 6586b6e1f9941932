// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <detection/geopackage.h>

#include <string>

namespace {

using namespace pcl_ops::apps;

/** \brief The bytes of a map with one feature.
 * \param[in] geometry as in GeoJSON */
std::string
packageOf (const std::string& geometry)
{
  return geoPackageOf (R"({"type":"FeatureCollection","features":[{"type":"Feature",)"
                       R"("geometry":)" +
                           geometry + R"(,"properties":{"layer":"WALL"}}]})",
                       "plan");
}

} // namespace

TEST (GeoPackage, HasNoGeometryOfAWallWithoutASolidPart)
{
  if (!hasSqlite())
    GTEST_SKIP() << "built without SQLite";
  // A wall is a line for each part between openings; this one has no such part.
  const std::string none = R"({"type":"MultiLineString","coordinates":[]})";
  EXPECT_EQ (packageOf (none), packageOf ("null"));
}
