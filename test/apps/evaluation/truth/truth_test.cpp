// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <evaluation/data/data_sets.h>
#include <evaluation/metrics/metrics.h>

#include <algorithm>
#include <filesystem>

namespace {

using namespace pcl_ops::evaluation;
namespace fs = std::filesystem;

constexpr float spacing = 0.02f; // [m]

/** A square of n x n points spanned by two unit vectors from a corner. */
void
addSquare (XyzCloud& cloud,
           int n,
           const Eigen::Vector3f& corner,
           const Eigen::Vector3f& u,
           const Eigen::Vector3f& v)
{
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      pcl::PointXYZ point;
      point.getVector3fMap() = corner + spacing * (i * u + j * v);
      cloud.push_back (point);
    }
}

const Eigen::Vector3f x = Eigen::Vector3f::UnitX(), y = Eigen::Vector3f::UnitY(),
                      z = Eigen::Vector3f::UnitZ();

/** A floor of 900 points and a wall of 400 that stands in its middle. */
XyzCloud
squareFloorAndWall ()
{
  XyzCloud cloud;
  addSquare (cloud, 30, {0, 0, 0}, x, y);
  addSquare (cloud, 20, {0.1f, 0.31f, 0.02f}, x, z);
  return cloud;
}

std::size_t
pointsWith (const PlaneLabels& labels, std::uint32_t label)
{
  return static_cast<std::size_t> (std::count (labels.begin(), labels.end(), label));
}

TEST (RegionGrowing, SeparatesAFloorFromTheWallOnIt)
{
  const PlaneLabels labels = growRegions (squareFloorAndWall(), 9);
  EXPECT_EQ (planeIds (labels).size(), 2u);
  EXPECT_EQ (labels[0], 1u);         // the larger one first
  EXPECT_EQ (labels[900 + 399], 2u); // the wall's upper corner
  EXPECT_GT (pointsWith (labels, 1), 800u);
  EXPECT_GT (pointsWith (labels, 2), 350u);
}

TEST (RegionGrowing, EndsWhereASurfaceLeavesItsPlane)
{
  // A cylinder of radius 1 m: 5 cm off the plane through its top at 0.31 m.
  XyzCloud cloud;
  for (int i = -60; i <= 60; ++i)
    for (int j = 0; j < 20; ++j)
      cloud.push_back (
          pcl::PointXYZ (std::sin (0.01f * i), spacing * j, std::cos (0.01f * i)));
  const PlaneLabels labels = growRegions (cloud, 9);
  EXPECT_GT (planeIds (labels).size(), 1u);
}

TEST (RegionGrowing, RegionsOfUnderFiftyPointsAreOnNoPlane)
{
  XyzCloud cloud;
  addSquare (cloud, 7, {0, 0, 0}, x, y); // 49 points
  addSquare (cloud, 8, {2, 0, 0}, x, y); // 64 points
  const PlaneLabels labels = growRegions (cloud, 9);
  EXPECT_EQ (pointsWith (labels, 0), 49u);
  EXPECT_EQ (pointsWith (labels, 1), 64u);
}

TEST (RegionGrowing, EmptyTinyAndCollapsedCloudsHaveNoPlane)
{
  for (const std::size_t size : {0u, 1u, 2u, 3u, 200u})
    EXPECT_EQ (growRegions (XyzCloud (size, 1), 9), PlaneLabels (size, 0));
}

TEST (RegionGrowing, FindsTheExactPlanesOfARenderedRoom)
{
  const fs::path file =
      fs::path (PCL_OPS_DATA_DIR) / "clouds" / "icl_nuim_lr_frame0_gt.pcd";
  if (!fs::exists (file))
    GTEST_SKIP() << "no " << file;
  const EvaluationCloud cloud =
      dataSetOf ("clouds:" + file.string(), z.cast<double>()).at (0).load();
  const PlaneLabels grown = growRegions (*cloud.cloud, 30);
  const Metrics metrics = compareLabels (*cloud.cloud, *cloud.truth, grown);
  EXPECT_GT (metrics.named[1].second, 0.9);
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
  EXPECT_EQ (pointsWith (truthOf (cloud, parameters), 0), 49u);
  EXPECT_EQ (truthName (true, parameters), "exact");
}

} // namespace
