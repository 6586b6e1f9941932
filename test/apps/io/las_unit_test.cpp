// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <io/las_unit.h>
#include <support/cloud_values.h>
#include <support/las_bytes.h>

using namespace pcl_ops::apps;

namespace {

// A key of GeoTIFF, and values of keys.
constexpr std::uint16_t unit_of_length = 3076;
constexpr std::uint16_t projected = 1, geographic_model = 2;
constexpr std::uint16_t meter = 9001, foot = 9002, us_foot = 9003;

class LasUnitTest : public CloudFolder {
protected:
  /** \brief Unit of a LAS with this variable length record. */
  LasUnit
  unitWith (std::uint16_t record, const std::string& content) const
  {
    LasRecipe recipe;
    recipe.vlrs.push_back (lasVlr ("LASF_Projection", record, content));
    return unitOf (*load ("a.las", lasBytes (recipe)).las);
  }

  /** \brief Unit of a LAS with a GeoKeyDirectoryTag: its header of four numbers, and
   * for each key its id, 0, 1 and its value. */
  LasUnit
  unitWithKeys (const std::vector<std::uint16_t>& keys) const
  {
    constexpr std::uint16_t keys_of_geotiff = 34735;
    std::string bytes;
    for (const std::uint16_t number : keys)
      bytes += bytesOf (LasHeader::UInt16 (number));
    return unitWith (keys_of_geotiff, bytes);
  }
};

const std::string geographic =
    R"(GEOGCS["WGS 84",DATUM["d",SPHEROID["s",6378137,298]],UNIT["degree",0.0174]])";

} // namespace

TEST_F (LasUnitTest, IsThatOfLengthsOfAProjectedSystem)
{
  EXPECT_EQ (unitInWkt ("PROJCS[\"UTM\"," + geographic + ",UNIT[\"metre\",1]]"),
             LasUnit::Meter);
  EXPECT_EQ (unitInWkt ("PROJCS[\"a\"," + geographic + ",UNIT[\"Foot_US\",0.3048]]"),
             LasUnit::Foot);
  EXPECT_EQ (unitInWkt ("PROJCRS[\"a\",CS[Cartesian,2],LENGTHUNIT[\"foot\",0.3048]]"),
             LasUnit::Foot);
  EXPECT_EQ (unitInWkt (geographic), LasUnit::Degree);
  EXPECT_EQ (unitInWkt ("LOCAL_CS[\"mine\"]"), LasUnit::Unknown);
}

TEST_F (LasUnitTest, IsNotThatOfHeights)
{
  EXPECT_EQ (unitInWkt ("COMPD_CS[\"a\",PROJCS[\"b\",UNIT[\"metre\",1]],"
                        "VERT_CS[\"c\",UNIT[\"foot\",0.3048]]]"),
             LasUnit::Meter);
}

TEST_F (LasUnitTest, IsReadFromTheTextOfAFile)
{
  EXPECT_EQ (unitWith (wkt_id, "PROJCS[\"a\",UNIT[\"US survey foot\",0.3048]]"),
             LasUnit::Foot);
  EXPECT_EQ (unitWith (wkt_id, ""), LasUnit::Unknown);
}

TEST_F (LasUnitTest, IsReadFromTheKeysOfAFile)
{
  const std::vector<std::uint16_t> header = {1, 1, 0, 2};
  const auto unitOfKeys = [&] (std::initializer_list<std::uint16_t> keys) {
    std::vector<std::uint16_t> all = header;
    all.insert (all.end(), keys);
    return unitWithKeys (all);
  };
  const auto unitOfProjected = [&] (std::uint16_t key, std::uint16_t value) {
    return unitOfKeys ({model_type, 0, 1, projected, key, 0, 1, value});
  };
  EXPECT_EQ (unitOfProjected (unit_of_length, meter), LasUnit::Meter);
  EXPECT_EQ (unitOfProjected (unit_of_length, foot), LasUnit::Foot);
  EXPECT_EQ (unitOfProjected (unit_of_length, us_foot), LasUnit::Foot);
  EXPECT_EQ (unitOfKeys ({model_type, 0, 1, geographic_model}), LasUnit::Degree);
  EXPECT_EQ (unitOfProjected (projected_system, 32632), LasUnit::Unknown);
  EXPECT_EQ (unitWithKeys ({1, 1}), LasUnit::Unknown) << "cut short";
}
