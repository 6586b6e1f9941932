// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <evaluation/data/data_sets.h>

#include <algorithm>
#include <filesystem>

namespace {

using namespace pcl_ops::evaluation;
using Eigen::Vector3f;
namespace fs = std::filesystem;

TEST (DataSets, ScenesAreACloudForEachSeed)
{
  for (const auto& [kind, last] : {std::pair ("rooms", "room-0011"),
                                   {"rooms-raw", "room-0011"},
                                   {"furniture", "furniture-0011"},
                                   {"survey", "survey-0011"},
                                   {"shapes", "shapes-0011"},
                                   {"streets", "street-0011"},
                                   {"streets-32", "street-0011"},
                                   {"streets-16", "street-0011"},
                                   {"streets-livox", "street-0011"}}) {
    const DataSet scenes = dataSetOf (kind + std::string (":9-11"));
    EXPECT_EQ (scenes.at (0).data_set, kind);
    ASSERT_EQ (scenes.size(), 3u);
    EXPECT_EQ (scenes[2].name, last);
  }
}

TEST (DataSets, SimulatedCloudsComeWithTheirTruthAndAreRepeatable)
{
  const struct {
    const char* text;
    std::size_t min_planes;
    bool is_image;
    float min_height; // of the sensor
  } rows[] = {{"shapes:1", 2, false, -1.0f},
              {"furniture:1", 10, true, 0.5f},
              {"streets-16:1", 10, false, 0.5f},
              {"rooms:2", 10, true, 0.5f}};
  for (const auto& row : rows) {
    SCOPED_TRACE (row.text);
    const CloudSource source = dataSetOf (row.text).at (0);
    const EvaluationCloud cloud = source.load(), again = source.load();
    ASSERT_TRUE (cloud.truth);
    EXPECT_EQ (cloud.truth->size(), cloud.cloud->size());
    EXPECT_GE (planeIds (*cloud.truth).size(), row.min_planes);
    EXPECT_EQ (cloud.truth, again.truth);
    EXPECT_EQ (bool (cloud.image), row.is_image);
    EXPECT_GT (cloud.cloud->sensor_origin_.z(), row.min_height);
  }
}

/** A square of n x n points, 2 cm apart, spanned by x and another axis. */
void
addSquare (XyzCloud& cloud, int n, const Vector3f& corner, const Vector3f& axis)
{
  for (int i = 0; i < n * n; ++i) {
    const Vector3f point =
        corner + 0.02f * (float (i / n) * Vector3f::UnitX() + float (i % n) * axis);
    cloud.emplace_back (point.x(), point.y(), point.z());
  }
}

/** A floor of 900 points and a wall of 400 that stands in its middle. */
XyzCloud
squareFloorAndWall ()
{
  XyzCloud cloud;
  addSquare (cloud, 30, {0, 0, 0}, Vector3f::UnitY());
  addSquare (cloud, 20, {0.1f, 0.31f, 0.02f}, Vector3f::UnitZ());
  return cloud;
}

std::ptrdiff_t
pointsWith (const PlaneLabels& labels, std::uint32_t label)
{
  return std::count (labels.begin(), labels.end(), label);
}

TEST (RegionGrowing, SeparatesAFloorFromTheWallOnIt)
{
  const PlaneLabels labels = growRegions (squareFloorAndWall(), 9);
  EXPECT_EQ (planeIds (labels).size(), 2u);
  EXPECT_EQ (labels[0], 1u);         // the larger one first
  EXPECT_EQ (labels[900 + 399], 2u); // the wall's upper corner
  EXPECT_GT (pointsWith (labels, 1), 800);
  EXPECT_GT (pointsWith (labels, 2), 350);
}

TEST (RegionGrowing, EndsWhereASurfaceLeavesItsPlane)
{
  // A cylinder of radius 1 m: 5 cm off the plane through its top at 0.31 m.
  XyzCloud cloud;
  for (int i = -60; i <= 60; ++i)
    for (int j = 0; j < 20; ++j)
      cloud.emplace_back (std::sin (0.01f * i), 0.02f * j, std::cos (0.01f * i));
  EXPECT_GT (planeIds (growRegions (cloud, 9)).size(), 1u);
}

TEST (RegionGrowing, RegionsOfUnderFiftyPointsAreOnNoPlane)
{
  XyzCloud cloud;
  addSquare (cloud, 7, {0, 0, 0}, Vector3f::UnitY()); // 49 points
  addSquare (cloud, 8, {2, 0, 0}, Vector3f::UnitY()); // 64 points
  const PlaneLabels labels = growRegions (cloud, 9);
  EXPECT_EQ (pointsWith (labels, 0), 49);
  EXPECT_EQ (pointsWith (labels, 1), 64);
}

TEST (RegionGrowing, EmptyTinyAndCollapsedCloudsHaveNoPlane)
{
  for (const std::size_t size : {0u, 1u, 2u, 3u, 200u})
    EXPECT_EQ (growRegions (XyzCloud (size, 1), 9), PlaneLabels (size, 0));
}

TEST (RegionGrowing, FindsTheExactPlanesOfARenderedRoom)
{
  const auto file = fs::path (PCL_OPS_DATA_DIR) / "clouds/icl_nuim_lr_frame0_gt.pcd";
  if (!fs::exists (file))
    GTEST_SKIP() << "no " << file;
  const EvaluationCloud cloud = dataSetOf ("clouds:" + file.string()).at (0).load();
  const PlaneLabels grown = growRegions (*cloud.cloud, 30);
  EXPECT_GT (compareLabels (*cloud.cloud, *cloud.truth, grown).named[1].second, 0.9);
}

TEST (Truth, IsTheExactOneButForSmallPlanesOrGrown)
{
  const TruthParameters parameters{9};
  EvaluationCloud cloud;
  cloud.cloud.reset (new XyzCloud (squareFloorAndWall()));
  EXPECT_EQ (truthOf (cloud, parameters), growRegions (*cloud.cloud, 9));
  EXPECT_EQ (truthName (false, parameters), "grown-k9");
  cloud.truth = PlaneLabels (cloud.cloud->size(), 3);
  std::fill_n (cloud.truth->begin(), 49, 8);
  EXPECT_EQ (pointsWith (truthOf (cloud, parameters), 0), 49);
  EXPECT_EQ (truthName (true, parameters), "exact");
}

} // namespace
