// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud/points.h"
#include "scene.h"

#include <algorithm>
#include <cmath>
#include <limits>

using pcl_ops::CloudView;
using namespace pcl_ops::internal;

namespace {

/** \brief An unorganized cloud of these points. */
pcl::PointCloud<pcl::PointXYZ>
cloudOf (std::initializer_list<pcl::PointXYZ> points)
{
  pcl::PointCloud<pcl::PointXYZ> cloud;
  cloud.insert (cloud.end(), points.begin(), points.end());
  return cloud;
}

/** \brief The position of point i in the frame of the input cloud. */
Eigen::Vector3d
inInputFrame (const Points& points, std::size_t i)
{
  return points.origin + points[i];
}

} // namespace

TEST (FinitePoints, DropsNanAndInfinityWhateverIsDenseSays)
{
  auto cloud = cloudOf (
      {{NAN, 0, 0}, {1, 2, 3}, {0, INFINITY, 0}, {4, 5, 6}, {0, 0, -INFINITY}});
  for (const bool is_dense : {true, false}) {
    cloud.is_dense = is_dense;
    const Points points = finitePoints (CloudView (cloud), one_thread);
    EXPECT_EQ (points.index, (pcl::Indices{1, 3}));
    EXPECT_EQ (points.size(), 2u);
  }
}

TEST (FinitePoints, ShareAFrameWithOthersOfTheirSurroundings)
{
  // The corners of a square of two meters, a thousand kilometers out, and the middles
  // of its sides.
  const float far = 1e6f;
  const auto corners =
      cloudOf ({{far, 0, 0}, {far + 2, 0, 0}, {far, 2, 0}, {far + 2, 2, 0}});
  const auto middles =
      cloudOf ({{far + 1, 0, 0}, {far + 1, 2, 0}, {far, 1, 0}, {far + 2, 1, 0}});
  const Eigen::Vector3d origin = finitePoints (CloudView (corners), one_thread).origin;
  EXPECT_EQ (finitePoints (CloudView (middles), one_thread).origin, origin);
  EXPECT_NEAR (origin.x(), far, 32.0) << "near enough for single precision";
}

TEST (FinitePoints, HaveTheSameOriginInAnyOrder)
{
  // Every seventh point lies 5 km away.
  pcl::PointCloud<pcl::PointXYZ> cloud;
  constexpr float far = 1e6f;
  for (int i = 0; i < 600; ++i)
    cloud.push_back ({far + static_cast<float> (i % 7 == 0 ? 5000 + i : i), 0, 0});
  const Eigen::Vector3d origin = finitePoints (CloudView (cloud), one_thread).origin;
  EXPECT_NEAR (origin.x(), far, 4096.0) << "zero would be the same in any order";
  std::sort (cloud.begin(), cloud.end(), [] (auto& a, auto& b) { return a.x < b.x; });
  EXPECT_EQ (finitePoints (CloudView (cloud), one_thread).origin, origin);
}

TEST (FinitePoints, HaveTheirOriginAtThemIfTheyAreEqualOrOnlyOneIsNotMissing)
{
  const float far = 1e6f;
  pcl::PointCloud<pcl::PointXYZ> cloud;
  cloud.resize (1000, pcl::PointXYZ (far, far, far));
  EXPECT_EQ (finitePoints (CloudView (cloud), one_thread).origin.x(), far);
  for (std::size_t i = 1; i < cloud.size(); ++i)
    cloud[i].x = NAN;
  EXPECT_EQ (finitePoints (CloudView (cloud), one_thread).origin.x(), far);
}

TEST (FinitePoints, HaveTheirOriginAtAMultipleOfAStep)
{
  constexpr double step = 1.25;
  const auto cloud = cloudOf ({{17, 2, -9}, {18, 3, -8}, {18, 2, -7}});
  const Points points = finitePoints (CloudView (cloud), one_thread, nullptr, step);
  for (const double coordinate : points.origin)
    EXPECT_EQ (std::remainder (coordinate, step), 0.0);
  EXPECT_EQ (inInputFrame (points, 0), Eigen::Vector3d (17, 2, -9));
}

TEST (FinitePoints, KeepPointsNearTheLargestNumber)
{
  // The middle of the points rounds to 2^128, which is no number of single precision.
  constexpr float largest = std::numeric_limits<float>::max();
  for (const float sign : {1.0f, -1.0f}) {
    pcl::PointCloud<pcl::PointXYZ> cloud;
    for (const float share : {0.96f, 0.97f, 0.98f, 0.99f, 1.0f})
      cloud.emplace_back (sign * share * largest, 0.0f, share);
    for (const double step : {0.0, 1e37}) {
      const Points points = finitePoints (CloudView (cloud), one_thread, nullptr, step);
      EXPECT_TRUE (points.origin.allFinite()) << points.origin.transpose();
      EXPECT_EQ (points.size(), cloud.size());
    }
  }
}

TEST (FinitePoints, KeepPointsAtBothEndsOfTheNumbers)
{
  // Seen from a point at one end, those at the other end are at infinity.
  constexpr float largest = std::numeric_limits<float>::max();
  const auto cloud = cloudOf (
      {{largest, 0, 0}, {largest, 1, 0}, {largest, 2, 0}, {-largest, 0, 0}, {0, 1, 0}});
  EXPECT_EQ (finitePoints (CloudView (cloud), one_thread).size(), cloud.size());
}

TEST (FinitePoints, KnowWhereTheyCameFrom)
{
  const float far = 1e6f;
  const auto cloud =
      cloudOf ({{far + 1, -far, 3}, {far + 4, -far, 6}, {far + 7, -far, 9}});
  for (const pcl::Indices& given :
       {pcl::Indices{0, 1, 2}, pcl::Indices{2, 0, 1, 1}, pcl::Indices{1, 2}}) {
    const Points points = finitePoints (CloudView (cloud), one_thread, &given);
    const bool are_all = given.size() > 2; // otherwise all but the first point
    EXPECT_EQ (points.index.empty(), are_all)
        << "no indices are needed for the whole cloud";
    ASSERT_EQ (points.size(), are_all ? 3u : 2u);
    for (std::size_t i = 0; i < points.size(); ++i) {
      EXPECT_EQ (points.indexOf (i), static_cast<pcl::index_t> (are_all ? i : i + 1));
      EXPECT_EQ (inInputFrame (points, i).cast<float>(),
                 cloud[points.indexOf (i)].getVector3fMap());
      EXPECT_LE (points[i].norm(), 100.0) << "small numbers far from zero";
    }
  }
}

TEST (DistinctPoints, KnowWhereTheyCameFromAndWhereTheirCopiesAre)
{
  const pcl::PointXYZ one (1, 2, 3), two (4, 5, 6), three (7, 8, 9);
  const auto cloud = cloudOf ({one, one, two, one, three, two, three});
  const Points points = distinctPoints (CloudView (cloud), one_thread);
  EXPECT_EQ (points.index, (pcl::Indices{0, 2, 4}));
  ASSERT_EQ (points.size(), 3u);
  EXPECT_EQ (inInputFrame (points, 1), Eigen::Vector3d (4, 5, 6));
  EXPECT_EQ (inInputFrame (points, 2), Eigen::Vector3d (7, 8, 9));
  // The index in the cloud, and the index of the point that represents the copy.
  std::vector<std::pair<pcl::index_t, std::uint32_t>> copies;
  for (const Copy& copy : points.copies)
    copies.emplace_back (copy.index, copy.point);
  EXPECT_EQ (copies, (decltype (copies){{1, 0}, {3, 0}, {5, 1}, {6, 2}}));
}

TEST (FinitePoints, KeepTheirDigitsBesideOneStrayPoint)
{
  auto cloud = cloudOf ({{1e7f, 1e7f, 1e7f}});
  for (int i = 0; i < 20; ++i)
    cloud.push_back ({0.1f * static_cast<float> (i), 0.3f, 0.7f});
  const Points points = finitePoints (CloudView (cloud), one_thread);
  ASSERT_EQ (points.size(), cloud.size());
  for (std::size_t i = 1; i < points.size(); ++i)
    EXPECT_NEAR (
        (inInputFrame (points, i) - cloud[i].getVector3fMap().cast<double>()).norm(),
        0.0,
        1e-6);
}

TEST (SamplePoints, AreTheSameInAnyOrder)
{
  Coordinates points, reversed; // no two points are equal
  for (int i = 1; i <= 1000; ++i) {
    points.add (0.37f * i, 1.0f / i, 2.0f);
    reversed.add (0.37f * (1001 - i), 1.0f / (1001 - i), 2.0f);
  }
  constexpr std::size_t wanted = 100;
  const std::vector<float> sample = samplePoints (points, wanted).x;
  const std::vector<float> of_reversed = samplePoints (reversed, wanted).x;
  EXPECT_TRUE (std::equal (
      sample.begin(), sample.end(), of_reversed.rbegin(), of_reversed.rend()));
  EXPECT_GT (sample.size(), wanted / 2);
  EXPECT_LT (sample.size(), wanted * 3 / 2);
}

TEST (MedianOf, IsTheMiddleValueOrTheUpperOfBothMiddleValuesOrZeroOfNone)
{
  std::vector<float> odd{3, 1, 2}, even{4, 1, 2, 3}, none;
  EXPECT_EQ (medianOf (odd), 2.0);
  EXPECT_EQ (medianOf (even), 3.0);
  EXPECT_EQ (medianOf (none), 0.0);
}
