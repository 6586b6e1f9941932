// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <evaluation/data/data_sets.h>
#include <support/temporary_folder.h>
#include <support/text.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <string>

namespace {

using namespace pcl_ops::evaluation;
using Eigen::Vector3f;
namespace fs = std::filesystem;

/** Adds a square of side x side points, 2 cm apart, spanned by the x axis and \p axis.
 */
void
addSquare (XyzCloud& cloud, int side, const Vector3f& corner, const Vector3f& axis)
{
  for (int i = 0; i < side * side; ++i) {
    const Vector3f point = corner + 0.02f * (float (i / side) * Vector3f::UnitX() +
                                             float (i % side) * axis);
    cloud.emplace_back (point.x(), point.y(), point.z());
  }
}

/** A floor of 900 points, then a wall of 400 that stands in its middle. */
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
  // A cylinder of radius 1 m: 0.31 m beside its top it is 5 cm below the tangent plane.
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
  const NamedValues values = compareLabels (*cloud.cloud, *cloud.truth, grown).named;
  const std::map<std::string, double> metrics (values.begin(), values.end());
  EXPECT_GT (metrics.at ("segmentation_accuracy"), 0.9);
}

TEST (Truth, IsExactWithoutSmallPlanesElseGrown)
{
  const TruthParameters parameters{9};
  EvaluationCloud cloud;
  cloud.cloud.reset (new XyzCloud (squareFloorAndWall()));
  EXPECT_EQ (truthOf (cloud, parameters), growRegions (*cloud.cloud, 9));
  cloud.truth = PlaneLabels (cloud.cloud->size(), 3);
  std::fill_n (cloud.truth->begin(), 49, 8);
  EXPECT_EQ (pointsWith (truthOf (cloud, parameters), 0), 49);
}

TEST (CloudsDataSet, AFolderThatCannotBeReadIsAnErrorNotTheEndOfTheClouds)
{
  if (::geteuid() == 0)
    GTEST_SKIP() << "root may read everything";
  const TemporaryFolder folder;
  folder.write ("floor.xyz", "0 0 0\n");
  fs::create_directory (folder / "closed");
  fs::permissions (folder / "closed", fs::perms::none);
  const std::string complaint =
      complaintOf ([&] { dataSetOf ("clouds:" + folder.path()); });
  fs::permissions (folder / "closed", fs::perms::owner_all); // for its removal
  EXPECT_TRUE (contains (complaint, "has a folder that cannot be read")) << complaint;
}

TEST (SimulatedDataSet, SaysWhichPointsOfHillsAreUnknownAndAsksForSmallRoofs)
{
  const EvaluationCloud hills = dataSetOf ("airborne:2").at (0).load();
  ASSERT_EQ (hills.is_ignored.size(), hills.cloud->size());
  const PlaneLabels labels = truthOf (hills, {});
  std::map<std::uint32_t, int> points;
  int ignored = 0;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    ++points[labels[i]];
    ignored += hills.is_ignored[i] != 0;
    EXPECT_TRUE (hills.is_ignored[i] == 0 || labels[i] == 0);
  }
  EXPECT_GT (ignored, int (hills.cloud->size() / 2));
  int small_roofs = 0;
  for (const auto& [label, count] : points)
    small_roofs += label > 0 && count < int (TruthParameters().min_points);
  EXPECT_GT (small_roofs, 0);
}

TEST (SimulatedDataSet, HasItsUpAxisAlsoInACamerasFrame)
{
  const EvaluationCloud image = dataSetOf ("rooms-kinect:1").at (0).load();
  ASSERT_TRUE (image.image);
  EXPECT_LT (image.up.y(), -0.8); // y points down in such a frame
  EXPECT_NEAR (image.up.norm(), 1.0, 1e-9);
}

} // namespace
