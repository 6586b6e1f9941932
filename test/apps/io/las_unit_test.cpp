// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <io/las_unit.h>
#include <support/cloud_values.h>
#include <support/las_bytes.h>

#include <array>

using namespace pcl_ops::apps;

namespace {

class LasUnitTest : public CloudFolder {
protected:
  /** \brief A LAS with one variable length record. */
  LasFile
  fileWith (const std::string& record) const
  {
    LasRecipe recipe;
    recipe.vlrs = {record};
    return LasFile (folder_.write ("a.las", lasBytes (recipe)));
  }

  LasUnit
  unitWithKeys (const std::vector<std::array<std::uint16_t, 2>>& keys) const
  {
    LasFile las = fileWith (geoKeys (keys));
    return unitOf (las);
  }

  LasUnit
  heightUnitWithKeys (const std::vector<std::array<std::uint16_t, 2>>& keys) const
  {
    LasFile las = fileWith (geoKeys (keys));
    return heightUnitOf (las);
  }

  LasUnit
  unitWithText (const std::string& text) const
  {
    LasFile las = fileWith (lasVlr (projection_user, wkt_id, text));
    return unitOf (las);
  }
};

const std::string geographic_wkt =
    R"(GEOGCS["WGS 84",DATUM["d",SPHEROID["s",6378137,298]],UNIT["degree",0.0174]])";

} // namespace

TEST_F (LasUnitTest, IsTheUnitOfXAndY)
{
  EXPECT_EQ (unitInWkt ("PROJCS[\"UTM\"," + geographic_wkt + ",UNIT[\"metre\",1]]"),
             LasUnit::Meter);
  EXPECT_EQ (
      unitInWkt ("PROJCS[\"a\"," + geographic_wkt + ",UNIT[\"Foot_US\",0.3048006]]"),
      LasUnit::Foot);
  EXPECT_EQ (unitInWkt ("PROJCRS[\"a\",CS[Cartesian,2],LENGTHUNIT[\"foot\",0.3048]]"),
             LasUnit::Foot);
  EXPECT_EQ (unitInWkt (geographic_wkt), LasUnit::Degree);
  EXPECT_EQ (unitInWkt ("LOCAL_CS[\"mine\"]"), LasUnit::Unknown);
}

TEST_F (LasUnitTest, IsNotTheUnitOfHeights)
{
  EXPECT_EQ (unitInWkt ("COMPD_CS[\"a\",PROJCS[\"b\",UNIT[\"metre\",1]],"
                        "VERT_CS[\"c\",UNIT[\"foot\",0.3048]]]"),
             LasUnit::Meter);
}

TEST_F (LasUnitTest, IsFoundBehindANameThatHasAKeywordOfHeights)
{
  const std::string name = "California zone 6 (ftUS), vertical NAVD88, VERT_CS[";
  const std::string projected_part = "PROJCS[\"" + name + "\"," + geographic_wkt +
                                     ",UNIT[\"US survey foot\",0.3048006096012192]]";
  EXPECT_EQ (unitInWkt (projected_part), LasUnit::Foot);
  EXPECT_EQ (unitInWkt ("COMPD_CS[\"" + name + "\"," + projected_part +
                        ",VERT_CS [\"c\",UNIT[\"metre\",1]]]"),
             LasUnit::Foot);
}

TEST_F (LasUnitTest, IsNotTheUnitOfTheRangeOfHeightsInAUsage)
{
  EXPECT_EQ (
      unitInWkt ("PROJCRS[\"a\",CS[Cartesian,2],LENGTHUNIT[\"foot\",0.3048],"
                 "USAGE[SCOPE[\"s\"],VERTICALEXTENT[-9,9,LENGTHUNIT[\"metre\",1]]]]"),
      LasUnit::Foot);
}

TEST_F (LasUnitTest, OfHeightsIsTheUnitOfTheVerticalSystem)
{
  // The name of the system has a keyword, which must not count.
  const std::string begin = "COMPD_CS[\"VERT_CS[\",PROJCS[\"b\",UNIT[\"metre\",1]]";
  const std::string end = "[\"c\",VERT_DATUM[\"d\",2005],UNIT[\"foot\",0.3048]]]";
  for (const char* keyword : {"VERT_CS", "vertcrs", "VERTICALCRS", "VERT_CS \n"})
    EXPECT_EQ (heightUnitInWkt (begin + "," + keyword + end), LasUnit::Foot) << keyword;
  EXPECT_EQ (heightUnitInWkt (begin + "]"), LasUnit::Unknown);
  EXPECT_EQ (heightUnitInWkt (""), LasUnit::Unknown);
}

TEST_F (LasUnitTest, OfHeightsIsReadFromTheKeysOfAFile)
{
  EXPECT_EQ (
      heightUnitWithKeys ({{linear_unit, unit_meter}, {vertical_unit, unit_us_foot}}),
      LasUnit::Foot);
  EXPECT_EQ (
      heightUnitWithKeys ({{linear_unit, unit_foot}, {vertical_unit, unit_meter}}),
      LasUnit::Meter);
  EXPECT_EQ (heightUnitWithKeys ({{linear_unit, unit_foot}}), LasUnit::Unknown);
}

TEST_F (LasUnitTest, OfHeightsIsThatOfTheirSystemWhereNoKeyTellsTheUnit)
{
  constexpr std::uint16_t navd88_in_us_feet = 6360, navd88 = 5703, unknown = 1;
  EXPECT_EQ (heightUnitWithKeys ({{vertical_system, navd88_in_us_feet}}),
             LasUnit::Foot);
  EXPECT_EQ (heightUnitWithKeys ({{vertical_system, navd88}}), LasUnit::Meter);
  EXPECT_EQ (heightUnitWithKeys ({{vertical_system, unknown}}), LasUnit::Unknown);
  EXPECT_EQ (
      heightUnitWithKeys ({{vertical_system, navd88}, {vertical_unit, unit_foot}}),
      LasUnit::Foot);
}

TEST_F (LasUnitTest, IsReadFromTheTextOfAFile)
{
  EXPECT_EQ (unitWithText ("PROJCS[\"a\",UNIT[\"US survey foot\",0.3048006]]"),
             LasUnit::Foot);
  EXPECT_EQ (unitWithText (""), LasUnit::Unknown);
}

TEST_F (LasUnitTest, IsThatOfTheTextOrOfTheKeysAsTheBitOfTheHeaderSays)
{
  LasRecipe recipe;
  recipe.vlrs = {
      lasVlr (projection_user, wkt_id, "PROJCS[\"a\",UNIT[\"foot\",0.3048]]"),
      geoKeys ({{linear_unit, unit_meter}})};
  recipe.global_encoding = wkt_bit;
  LasFile with_bit (folder_.write ("a.las", lasBytes (recipe)));
  EXPECT_EQ (unitOf (with_bit), LasUnit::Foot);
  recipe.global_encoding = 0;
  LasFile without_bit (folder_.write ("b.las", lasBytes (recipe)));
  EXPECT_EQ (unitOf (without_bit), LasUnit::Meter);
}

TEST_F (LasUnitTest, IsReadFromTheKeysOfAFile)
{
  const auto unitOfProjected = [&] (std::uint16_t unit) {
    return unitWithKeys ({{model_type, projected_model}, {linear_unit, unit}});
  };
  EXPECT_EQ (unitOfProjected (unit_meter), LasUnit::Meter);
  EXPECT_EQ (unitOfProjected (unit_foot), LasUnit::Foot);
  EXPECT_EQ (unitOfProjected (unit_us_foot), LasUnit::Foot);
  EXPECT_EQ (unitWithKeys ({{model_type, geographic_model}}), LasUnit::Degree);
  LasFile cut_short =
      fileWith (lasVlr (projection_user, geo_keys_id, std::string ("\1\0\1\0", 4)));
  EXPECT_EQ (unitOf (cut_short), LasUnit::Unknown);
}

TEST_F (LasUnitTest, IsThatOfANumberedSystemWhereNoKeyTellsTheUnit)
{
  constexpr std::uint16_t utm_zone_32 = 32632, undefined = 0, user_defined = 32767;
  EXPECT_EQ (unitWithKeys ({{projected_system, california_in_us_feet}}), LasUnit::Foot);
  EXPECT_EQ (unitWithKeys ({{projected_system, california_in_us_feet},
                            {linear_unit, unit_meter}}),
             LasUnit::Meter);
  EXPECT_EQ (unitWithKeys ({{projected_system, utm_zone_32}}), LasUnit::Meter);
  for (const std::uint16_t no_number : {undefined, user_defined})
    EXPECT_EQ (unitWithKeys ({{projected_system, no_number}}), LasUnit::Unknown);
}
