// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <evaluation/data/changed_clouds.h>

#include <algorithm>
#include <stdexcept>
#include <string>

namespace {

using namespace pcl_ops::evaluation;

/** Returns \p count points along x, 0.25 m apart, at z = 2 m. */
XyzCloud
rowOf (int count)
{
  XyzCloud cloud;
  for (int i = 0; i < count; ++i)
    cloud.push_back (pcl::PointXYZ (0.25f * float (i), 0, 2));
  return cloud;
}

ChangedCloud
changedBy (const std::string& name,
           const XyzCloud& cloud,
           const Vector3d& up = Vector3d::UnitZ())
{
  for (const CloudChange& change : cloud_changes)
    if (change.name == name)
      return changedCloud (cloud, up, change);
  throw std::invalid_argument (name);
}

/** Returns the largest change of a coordinate; both clouds have the same points. */
float
largestChange (const XyzCloud& before, const XyzCloud& after)
{
  float largest = 0.0f;
  for (std::size_t i = 0; i < before.size(); ++i)
    largest = std::max (
        largest,
        (after[i].getVector3fMap() - before[i].getVector3fMap()).cwiseAbs().maxCoeff());
  return largest;
}

TEST (ChangedClouds, MovedPointsAndTheirSensorGoTheSameWay)
{
  const ChangedCloud moved = changedBy ("moved", rowOf (4));
  const Eigen::Vector3f shift (0.0371f, 0.0613f, 0.0829f);
  for (int i = 0; i < 4; ++i)
    EXPECT_TRUE ((*moved.cloud)[i].getVector3fMap().isApprox (
        Eigen::Vector3f (0.25f * float (i), 0, 2) + shift));
  EXPECT_EQ (moved.cloud->sensor_origin_.head<3>(), shift);
}

TEST (ChangedClouds, TurnedPointsGoBy30DegreesAboutZWithSensorAndUpAxis)
{
  XyzCloud cloud = rowOf (5);
  cloud.sensor_origin_.head<3>() = Eigen::Vector3f (0, 1, 0);
  const ChangedCloud turned = changedBy ("turned", cloud, Vector3d::UnitX());
  // A point 1 m along x goes to the cosine and sine of 30 degrees.
  EXPECT_TRUE ((*turned.cloud)[4].getVector3fMap().isApprox (
      Eigen::Vector3f (0.8660254f, 0.5f, 2)));
  EXPECT_TRUE (turned.cloud->sensor_origin_.head<3>().isApprox (
      Eigen::Vector3f (-0.5f, 0.8660254f, 0)));
  EXPECT_TRUE ((turned.cloud->sensor_orientation_ * Eigen::Vector3f::UnitX())
                   .isApprox (Eigen::Vector3f (0.8660254f, 0.5f, 0)));
  EXPECT_TRUE (turned.up.isApprox (Vector3d (0.8660254037844386, 0.5, 0)));
}

TEST (ChangedClouds, ThinnedOnesSayWhereTheirPointsWere)
{
  const XyzCloud cloud = rowOf (1000);
  const ChangedCloud thinned = changedBy ("thinned", cloud);
  ASSERT_EQ (thinned.cloud->size(), 990u);
  ASSERT_EQ (thinned.points.size(), 990u);
  EXPECT_TRUE (std::is_sorted (thinned.points.begin(), thinned.points.end()));
  for (std::size_t i = 0; i < 990; ++i)
    EXPECT_EQ ((*thinned.cloud)[i].x, cloud[thinned.points[i]].x);
}

TEST (DrawIndices, GivesAsManyAsAskedFor)
{
  EXPECT_EQ (drawIndices (3, 3), (pcl::Indices{0, 1, 2}));
  EXPECT_TRUE (drawIndices (3, 0).empty());
  const pcl::Indices points = drawIndices (1000, 500);
  ASSERT_EQ (points.size(), 500u);
  EXPECT_TRUE (std::is_sorted (points.begin(), points.end()));
  EXPECT_NEAR (std::count_if (points.begin(),
                              points.end(),
                              [] (auto point) { return point < 500; }),
               250,
               50)
      << "of the first half";
}

TEST (ChangedClouds, SmallOnesLoseAPointAndEmptyOnesNone)
{
  EXPECT_EQ (changedBy ("thinned", rowOf (7)).cloud->size(), 6u);
  for (const CloudChange& change : cloud_changes)
    EXPECT_TRUE (changedCloud ({}, Vector3d::UnitZ(), change).cloud->empty());
}

TEST (ChangedClouds, JitteredPointsGoByATenthOfAMillimeterAtMost)
{
  const XyzCloud cloud = rowOf (100);
  const float largest = largestChange (cloud, *changedBy ("jittered", cloud).cloud);
  EXPECT_LE (largest, 1.01e-4f);
  EXPECT_GE (largest, 0.9e-4f) << "of 300 draws";
}

TEST (ChangedClouds, RoundedPointsAreAtWholeMillimeters)
{
  XyzCloud cloud;
  cloud.push_back (pcl::PointXYZ (0.0014f, -0.0016f, 12.3456f));
  const ChangedCloud rounded = changedBy ("rounded", cloud);
  EXPECT_EQ ((*rounded.cloud)[0].getVector3fMap(),
             Eigen::Vector3f (0.001f, -0.002f, 12.346f));
}

TEST (ChangedClouds, AreTheSameEachTime)
{
  const XyzCloud cloud = rowOf (300);
  for (const CloudChange& change : cloud_changes) {
    const ChangedCloud once = changedCloud (cloud, Vector3d::UnitZ(), change);
    const ChangedCloud again = changedCloud (cloud, Vector3d::UnitZ(), change);
    ASSERT_FALSE (once.cloud->empty()) << change.name;
    ASSERT_EQ (once.cloud->size(), again.cloud->size()) << change.name;
    EXPECT_EQ (once.points, again.points) << change.name;
    EXPECT_EQ (largestChange (*once.cloud, *again.cloud), 0.0f) << change.name;
  }
}

} // namespace
