// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cli/errors.h>
#include <evaluation/data/data_sets.h>
#include <support/temporary_folder.h>

#include <filesystem>
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
  const std::pair<std::string, std::string> kinds[] = {
      {"rooms", "room-0011"},
      {"rooms-raw", "room-0011"},
      {"furniture", "furniture-0011"},
      {"survey", "survey-0011"},
      {"shapes", "shapes-0011"},
      {"streets", "street-0011"},
      {"streets-32", "street-0011"},
      {"streets-16", "street-0011"},
      {"streets-livox", "street-0011"}};
  for (const auto& [kind, last] : kinds) {
    const DataSet scenes = dataSet (kind + ":9-11");
    EXPECT_EQ (scenes.at (0).data_set, kind);
    ASSERT_EQ (scenes.size(), 3u);
    EXPECT_EQ (scenes[2].name, last);
  }
}

TEST (DataSets, SimulatedCloudsComeWithTheirTruthAndAreRepeatable)
{
  const std::pair<const char*, std::size_t> min_planes[] = {
      {"shapes:1", 2}, {"furniture:1", 10}, {"streets-16:1", 10}, {"rooms:2", 10}};
  for (const auto& [text, planes] : min_planes) {
    const CloudSource source = dataSet (text).at (0);
    const EvaluationCloud cloud = source.load(), again = source.load();
    ASSERT_TRUE (cloud.truth) << text;
    EXPECT_EQ (cloud.truth->size(), cloud.cloud->size()) << text;
    EXPECT_GE (planeIds (*cloud.truth).size(), planes) << text;
    EXPECT_EQ (cloud.truth, again.truth) << text;
    EXPECT_EQ (bool (cloud.image),
               text == std::string ("rooms:2") || text == std::string ("furniture:1"));
    if (text != std::string ("shapes:1")) {
      EXPECT_GT (cloud.cloud->sensor_origin_.z(), 0.5f) << text;
    }
  }
}

TEST (DataSets, RangesOfSeedsAreNeitherEmptyNorEndless)
{
  for (const char* text : {"rooms:3-1", "shapes:1-9999999", "rooms:0-4000000000"})
    EXPECT_THROW (dataSet (text), pcl_ops::apps::UsageError) << text;
}

TEST (DataSets, AFolderOfCloudsGivesItsName)
{
  const TemporaryFolder folder;
  std::filesystem::create_directories (folder / "roofs");
  const std::string file = folder.write ("roofs/one.xyz", "1 2 3\n");
  EXPECT_EQ (dataSet ("clouds:" + folder / "roofs").at (0).data_set, "roofs");
  EXPECT_EQ (dataSet ("clouds:" + file).at (0).data_set, "clouds");
}

} // namespace
