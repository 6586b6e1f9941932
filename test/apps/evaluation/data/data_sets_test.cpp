// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cli/errors.h>
#include <evaluation/data/data_sets.h>

#include <algorithm>
#include <set>

namespace {

using namespace pcl_ops::evaluation;

DataSet
dataSet (const std::string& text)
{
  return dataSetOf (text, Eigen::Vector3d::UnitZ());
}

TEST (DataSets, ScenesAreACloudForEachSeed)
{
  for (const std::string kind : {"furniture", "survey", "shapes"}) {
    const DataSet scenes = dataSet (kind + ":9-11");
    EXPECT_EQ (scenes.name, kind);
    ASSERT_EQ (scenes.clouds.size(), 3u);
    EXPECT_EQ (scenes.clouds[0].name, kind + "-0009");
    EXPECT_EQ (scenes.clouds[2].name, kind + "-0011");
  }
  EXPECT_EQ (dataSet ("rooms-raw:7").clouds.at (0).name, "room-0007");
}

TEST (DataSets, ShapesComeWithTheirTruth)
{
  const EvaluationCloud shapes = dataSet ("shapes:1").clouds.at (0).load();
  ASSERT_TRUE (shapes.truth);
  EXPECT_EQ (shapes.truth->size(), shapes.cloud->size());
  EXPECT_EQ (std::set<std::uint32_t> (shapes.truth->begin(), shapes.truth->end()),
             (std::set<std::uint32_t>{0, 1, 2}));
}

TEST (DataSets, FurnitureComesWithItsTruthAndCamera)
{
  const EvaluationCloud furniture = dataSet ("furniture:1").clouds.at (0).load();
  ASSERT_TRUE (furniture.truth);
  EXPECT_EQ (furniture.truth->size(), furniture.cloud->size());
  EXPECT_GT (
      std::set<std::uint32_t> (furniture.truth->begin(), furniture.truth->end()).size(),
      10u);
  EXPECT_GT (furniture.cloud->sensor_origin_.z(), 1.0f);
}

TEST (DataSets, StreetsAreAStreetForEachSeedAndSensor)
{
  for (const std::string kind :
       {"streets", "streets-32", "streets-16", "streets-livox"}) {
    const DataSet streets = dataSet (kind + ":9-11");
    EXPECT_EQ (streets.name, kind);
    ASSERT_EQ (streets.clouds.size(), 3u);
    EXPECT_EQ (streets.clouds[2].name, "street-0011");
  }
  const EvaluationCloud street = dataSet ("streets-16:1").clouds.at (0).load();
  ASSERT_TRUE (street.truth);
  EXPECT_EQ (street.truth->size(), street.cloud->size());
  EXPECT_GT (street.cloud->sensor_origin_.z(), 1.0f);
}

TEST (DataSets, AWrongRangeOfSeedsIsNamed)
{
  for (const std::string text : {"rooms:9-1", "survey:9-1", "shapes:1-9999999"})
    try {
      dataSet (text);
      FAIL() << text;
    }
    catch (const pcl_ops::apps::UsageError& error) {
      EXPECT_NE (std::string (error.what()).find (text), std::string::npos);
    }
}

} // namespace
