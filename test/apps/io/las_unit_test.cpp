// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <io/las_unit.h>
#include <support/cloud_values.h>
#include <support/las_bytes.h>

using namespace pcl_ops::apps;

namespace {

class LasUnitTest : public CloudFolder {
protected:
  LasUnit
  unitWith (std::uint16_t record, const std::string& content) const
  {
    LasRecipe recipe;
    recipe.vlrs.push_back (lasVlr ("LASF_Projection", record, content));
    return unitOf (*load ("a.las", lasBytes (recipe)).las);
  }

  /** \brief Unit of a LAS with GeoTIFF keys, each of them as id, 0, 1 and value. */
  LasUnit
  unitWithKeys (const std::vector<std::uint16_t>& keys) const
  {
    constexpr std::uint16_t keys_of_geotiff = 34735;
    std::string bytes;
    for (const std::uint16_t number : keys)
      bytes += bytesOf (LasHeader::Short (number));
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
  EXPECT_EQ (unitWith (2112, "PROJCS[\"a\",UNIT[\"US survey foot\",0.3048]]"),
             LasUnit::Foot);
  EXPECT_EQ (unitWith (2112, ""), LasUnit::Unknown);
}

TEST_F (LasUnitTest, IsReadFromTheKeysOfAFile)
{
  const std::vector<std::uint16_t> header = {1, 1, 0, 2};
  const auto with = [&] (std::initializer_list<std::uint16_t> keys) {
    std::vector<std::uint16_t> all = header;
    all.insert (all.end(), keys);
    return unitWithKeys (all);
  };
  EXPECT_EQ (with ({1024, 0, 1, 1, 3076, 0, 1, 9001}), LasUnit::Meter);
  EXPECT_EQ (with ({1024, 0, 1, 1, 3076, 0, 1, 9002}), LasUnit::Foot);
  EXPECT_EQ (with ({1024, 0, 1, 1, 3076, 0, 1, 9003}), LasUnit::Foot);
  EXPECT_EQ (with ({1024, 0, 1, 2}), LasUnit::Degree);
  EXPECT_EQ (with ({1024, 0, 1, 1, 3072, 0, 1, 32632}), LasUnit::Unknown);
  EXPECT_EQ (unitWithKeys ({1, 1}), LasUnit::Unknown) << "cut short";
}
