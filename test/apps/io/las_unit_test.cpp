// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <io/las_unit.h>
#include <support/cloud_values.h>
#include <support/las_bytes.h>

#include <array>

using namespace pcl_ops::apps;

namespace {

// Keys of GeoTIFF; las_bytes.h has those that other tests need, too.
constexpr std::uint16_t linear_unit_key = 3076, vertical_unit_key = 4099;
// Values of model_type, then of keys of units.
constexpr std::uint16_t model_projected = 1, model_geographic = 2;
constexpr std::uint16_t meter = 9001, foot = 9002, us_foot = 9003;

class LasUnitTest : public CloudFolder {
protected:
  /** \brief A LAS with one variable length record.
   * \param[in] record its id */
  LasFile
  fileWith (std::uint16_t record, const std::string& content) const
  {
    LasRecipe recipe;
    recipe.vlrs.push_back (lasVlr ("LASF_Projection", record, content));
    return LasFile (folder_.write ("a.las", lasBytes (recipe)));
  }

  /** \brief A LAS with a GeoKeyDirectoryTag of these numbers. */
  LasFile
  fileWithNumbers (const std::vector<std::uint16_t>& numbers) const
  {
    constexpr std::uint16_t keys_of_geotiff = 34735;
    std::string bytes;
    for (const std::uint16_t number : numbers)
      bytes += bytesOf (LasHeader::UInt16 (number));
    return fileWith (keys_of_geotiff, bytes);
  }

  /** \brief A LAS with these GeoTIFF keys. The GeoKeyDirectoryTag has a header of four
   * numbers, and then for each key its id, 0, 1 and its value.
   * \param[in] keys each key and its value */
  LasFile
  fileWithKeys (const std::vector<std::array<std::uint16_t, 2>>& keys) const
  {
    std::vector<std::uint16_t> numbers = {
        1, 1, 0, static_cast<std::uint16_t> (keys.size())};
    for (const auto& [key, value] : keys)
      numbers.insert (numbers.end(), {key, 0, 1, value});
    return fileWithNumbers (numbers);
  }

  LasUnit
  unitWithKeys (const std::vector<std::array<std::uint16_t, 2>>& keys) const
  {
    LasFile las = fileWithKeys (keys);
    return unitOf (las);
  }

  LasUnit
  heightUnitWithKeys (const std::vector<std::array<std::uint16_t, 2>>& keys) const
  {
    LasFile las = fileWithKeys (keys);
    return heightUnitOf (las);
  }

  LasUnit
  unitWithText (const std::string& text) const
  {
    LasFile las = fileWith (wkt_id, text);
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
      heightUnitWithKeys ({{linear_unit_key, meter}, {vertical_unit_key, us_foot}}),
      LasUnit::Foot);
  EXPECT_EQ (heightUnitWithKeys ({{linear_unit_key, foot}, {vertical_unit_key, meter}}),
             LasUnit::Meter);
  EXPECT_EQ (heightUnitWithKeys ({{linear_unit_key, foot}}), LasUnit::Unknown);
}

TEST_F (LasUnitTest, IsReadFromTheTextOfAFile)
{
  EXPECT_EQ (unitWithText ("PROJCS[\"a\",UNIT[\"US survey foot\",0.3048006]]"),
             LasUnit::Foot);
  EXPECT_EQ (unitWithText (""), LasUnit::Unknown);
}

TEST_F (LasUnitTest, IsReadFromTheKeysOfAFile)
{
  const auto unitOfProjected = [&] (std::uint16_t linear_unit) {
    return unitWithKeys (
        {{model_type, model_projected}, {linear_unit_key, linear_unit}});
  };
  EXPECT_EQ (unitOfProjected (meter), LasUnit::Meter);
  EXPECT_EQ (unitOfProjected (foot), LasUnit::Foot);
  EXPECT_EQ (unitOfProjected (us_foot), LasUnit::Foot);
  EXPECT_EQ (unitWithKeys ({{model_type, model_geographic}}), LasUnit::Degree);
  LasFile cut_short = fileWithNumbers ({1, 1});
  EXPECT_EQ (unitOf (cut_short), LasUnit::Unknown);
}

TEST_F (LasUnitTest, IsFeetByTheNumberOfASystemWhereNoKeyTellsTheUnit)
{
  constexpr std::uint16_t california_in_us_feet = 2230, utm_zone_32 = 32632;
  EXPECT_EQ (unitWithKeys ({{projected_system, california_in_us_feet}}), LasUnit::Foot);
  EXPECT_EQ (unitWithKeys (
                 {{projected_system, california_in_us_feet}, {linear_unit_key, meter}}),
             LasUnit::Meter);
  EXPECT_EQ (unitWithKeys ({{projected_system, utm_zone_32}}), LasUnit::Unknown);
}
