// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <io/las_crs.h>
#include <support/las_bytes.h>
#include <support/temporary_folder.h>

using namespace pcl_ops::apps;

namespace {

/** \brief The coordinate reference system that crsOf tells of a LAS with these variable
 * length records; empty if it tells none. */
std::string
crsOfRecords (const std::vector<std::string>& vlrs, std::uint16_t global_encoding = 0)
{
  const TemporaryFolder folder;
  LasRecipe recipe;
  recipe.vlrs = vlrs;
  recipe.global_encoding = global_encoding;
  LasFile las (folder.write ("a.las", lasBytes (recipe)));
  return crsOf (las);
}

constexpr std::uint16_t user_defined = 32767; // a system without a number

} // namespace

TEST (LasCrs, IsTheNumberOfAProjectedOrAGeographicSystemInTheKeys)
{
  EXPECT_EQ (crsOfRecords ({geoKeys ({{model_type, projected_model},
                                      {geographic_system, 4258},
                                      {projected_system, 25832}})}),
             "EPSG:25832");
  EXPECT_EQ (crsOfRecords ({geoKeys (
                 {{model_type, geographic_model}, {geographic_system, 4326}})}),
             "EPSG:4326");
}

TEST (LasCrs, IsEmptyWhereTheSystemHasNoNumberOrIsMissing)
{
  EXPECT_EQ (crsOfRecords ({geoKeys (
                 {{projected_system, user_defined}, {geographic_system, 4152}})}),
             "");
  EXPECT_EQ (crsOfRecords ({}), "");
  EXPECT_EQ (crsOfRecords ({lasVlr (projection_user, geo_keys_id, "short")}), "");
}

TEST (LasCrs, IsTheLastNumberOfATextAndZeroBytesBehindTheTextDoNotMatter)
{
  const std::string text = R"(PROJCS["UTM 32",GEOGCS["WGS",AUTHORITY["EPSG","4258"]],)"
                           R"(UNIT["metre",1],AUTHORITY["EPSG","25832"]])";
  EXPECT_EQ (
      crsOfRecords ({lasVlr (projection_user, wkt_id, text + std::string (3, '\0'))}),
      "EPSG:25832");
}

TEST (LasCrs, IsThatOfTheTextOrOfTheKeysAsTheBitOfTheHeaderSays)
{
  const std::string text =
      lasVlr (projection_user, wkt_id, R"(PROJCS["a",AUTHORITY["EPSG","2230"]])");
  const std::string keys = geoKeys ({{projected_system, 25832}});
  EXPECT_EQ (crsOfRecords ({text, keys}, wkt_bit), "EPSG:2230");
  EXPECT_EQ (crsOfRecords ({text, keys}), "EPSG:25832");
  EXPECT_EQ (crsOfRecords ({keys}, wkt_bit), "EPSG:25832") << "there is no text";
  EXPECT_EQ (crsOfRecords ({text}), "EPSG:2230") << "there are no keys";
}

TEST (LasCrs, InTextIsTheSystemOfXAndYNotOfHeights)
{
  EXPECT_EQ (crsInWkt (R"(COMPD_CS["a",PROJCS["b",AUTHORITY["EPSG","2992"]],)"
                       R"(VERT_CS["c",AUTHORITY["EPSG","5703"]]])"),
             "EPSG:2992");
  EXPECT_EQ (
      crsInWkt (R"(COMPD_CS["a",PROJCS["b, VERTICAL c",AUTHORITY["EPSG","2230"]],)"
                R"(VERT_CS ["c",AUTHORITY["EPSG","6360"]]])"),
      "EPSG:2230");
  EXPECT_EQ (crsInWkt ("PROJCRS[\"b\",\n  ID[\"EPSG\", 25832]\n]"), "EPSG:25832");
}

TEST (LasCrs, InTextIsEmptyWhereOnlyAPartHasANumber)
{
  EXPECT_EQ (crsInWkt (R"(PROJCS["b",UNIT["foot",0.3048,AUTHORITY["EPSG","9002"]]])"),
             "");
  EXPECT_EQ (crsInWkt (""), "");
}
