// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "presets.h"
#include "scene.h"
#include <pcl_ops/plane_extent.h>

#include <thread>

using pcl_ops::PlaneSegment;

namespace {

class Contract : public EachPreset {};

INSTANTIATE_TEST_SUITE_P (Presets,
                          Contract,
                          ::testing::Values ("default", "paper"),
                          presetName);

void
expectSameIndices (const std::vector<pcl::PointIndices>& clusters,
                   const std::vector<PlaneSegment>& planes)
{
  ASSERT_EQ (clusters.size(), planes.size());
  for (std::size_t i = 0; i < planes.size(); ++i)
    EXPECT_EQ (clusters[i].indices, planes[i].inliers);
}

Eigen::Vector4f
coefficientsOf (const PlaneSegment& plane)
{
  Eigen::Vector4d coefficients;
  coefficients << plane.normal, plane.plane().offset;
  return coefficients.cast<float>();
}

/** \brief Mean and root mean square distance of a plane's inliers, from the points. */
std::pair<Eigen::Vector3d, double>
centroidAndRms (const Cloud& cloud, const PlaneSegment& plane)
{
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double squares = 0.0;
  for (const pcl::index_t i : plane.inliers) {
    const Eigen::Vector3d point = cloud[i].getVector3fMap().cast<double>();
    sum += point;
    squares += plane.plane().distance (point) * plane.plane().distance (point);
  }
  const auto count = static_cast<double> (plane.inliers.size());
  return {sum / count, std::sqrt (squares / count)};
}

} // namespace

TEST_P (Contract, EveryOverloadGivesTheSamePlanes)
{
  Ops ops = detectorFor (room().build().cloud);
  const auto planes = planesOf (ops);
  std::vector<pcl::ModelCoefficients> coefficients (99); // what is there is replaced
  std::vector<pcl::PointIndices> inliers (99);
  ASSERT_TRUE (ops.segment (coefficients, inliers));
  expectSameIndices (inliers, planes);
  ASSERT_TRUE (ops.extract (inliers));
  expectSameIndices (inliers, planes);
  ASSERT_EQ (coefficients.size(), planes.size());
  for (std::size_t i = 0; i < planes.size(); ++i) {
    ASSERT_EQ (coefficients[i].values.size(), 4u);
    EXPECT_TRUE (coefficientsOf (planes[i]).isApprox (
        Eigen::Map<const Eigen::Vector4f> (coefficients[i].values.data())));
  }
  pcl::PointIndices of_largest;
  pcl::ModelCoefficients largest;
  ASSERT_TRUE (ops.segment (of_largest, largest)); // in the order of SACSegmentation
  EXPECT_EQ (of_largest.indices, planes.at (0).inliers);
  EXPECT_EQ (largest.values, coefficients[0].values);
}

TEST_P (Contract, GivesPlanarRegionsWithHullsAsContours)
{
  const auto cloud = room().build().cloud;
  Ops ops = detectorFor (cloud);
  const auto planes = planesOf (ops);
  Ops::PlanarRegions regions;
  ASSERT_TRUE (ops.segment (regions));
  ASSERT_EQ (regions.size(), planes.size());
  for (std::size_t i = 0; i < planes.size(); ++i) {
    EXPECT_TRUE (regions[i].getCoefficients().isApprox (coefficientsOf (planes[i])));
    EXPECT_TRUE (regions[i].getCentroid().isApprox (planes[i].centroid.cast<float>()));
    EXPECT_TRUE (regions[i].getCovariance().isApprox (
        planes[i].moments.covariance().cast<float>()));
    EXPECT_EQ (regions[i].getCount(), planes[i].inliers.size());
    const auto hull = pcl_ops::planeExtent (*cloud, planes[i]).hull;
    const auto& contour = regions[i].getContour();
    ASSERT_EQ (contour.size(), hull.size());
    for (std::size_t k = 0; k < hull.size(); ++k)
      EXPECT_TRUE (contour[k].getVector3fMap().isApprox (hull[k].cast<float>()));
  }
}

TEST_P (Contract, CopiesTheHeader)
{
  const auto cloud = room().build().cloud;
  cloud->header.frame_id = "camera";
  cloud->header.stamp = 1234;
  Ops ops = detectorFor (cloud);
  std::vector<pcl::ModelCoefficients> coefficients;
  std::vector<pcl::PointIndices> inliers;
  ASSERT_TRUE (ops.segment (coefficients, inliers));
  ASSERT_FALSE (inliers.empty());
  EXPECT_EQ (inliers.front().header.frame_id, "camera");
  EXPECT_EQ (inliers.front().header.stamp, 1234u);
  EXPECT_EQ (coefficients.front().header.frame_id, "camera");
}

TEST_P (Contract, GivesAscendingDisjointIndicesOfTheCloud)
{
  const auto cloud = room().build().cloud;
  Ops ops = detectorFor (cloud);
  std::vector<bool> taken (cloud->size(), false);
  for (const pcl::Indices& inliers : inliersOf (ops)) {
    EXPECT_TRUE (std::is_sorted (
        inliers.begin(), inliers.end(), std::less_equal<pcl::index_t>()));
    for (const pcl::index_t i : inliers) {
      EXPECT_FALSE (taken.at (i)) << "point " << i << " is on two planes";
      taken[i] = true;
    }
  }
}

TEST_P (Contract, SortsPlanesByFallingSize)
{
  Ops ops = detectorFor (Scene()
                             .floor (1, 1)
                             .floor (2, 2, 1)
                             .floor (1.5, 1, 2)
                             .floor (3, 1, 3)
                             .build()
                             .cloud);
  const auto planes = inliersOf (ops);
  ASSERT_EQ (planes.size(), 4u);
  for (std::size_t i = 1; i < planes.size(); ++i)
    EXPECT_GE (planes[i - 1].size(), planes[i].size());
}

TEST_P (Contract, PointsNormalsTowardsTheSensor)
{
  const auto scene = room().build();
  for (const float side :
       {1.0f, -1.0f}) { // in the room's middle and on the walls' far side
    scene.cloud->sensor_origin_ << side * 2, side * 1.5f, side * 1.2f, 0;
    Ops ops = detectorFor (scene.cloud);
    for (const PlaneSegment& plane : planesOf (ops)) {
      EXPECT_NEAR (plane.normal.norm(), 1.0, 1e-9);
      EXPECT_GT (
          plane.plane().distance (scene.cloud->sensor_origin_.head<3>().cast<double>()),
          0.0);
    }
  }
}

TEST_P (Contract, DescribesThePointsOfEachPlane)
{
  const auto scene = room().build();
  Ops ops = detectorFor (scene.cloud);
  for (const PlaneSegment& plane : planesOf (ops)) {
    const auto [centroid, rms] = centroidAndRms (*scene.cloud, plane);
    EXPECT_LT ((plane.centroid - centroid).norm(), 1e-6);
    EXPECT_NEAR (plane.rms(), rms, 1e-6);
    EXPECT_LT (plane.rms(), 1_cm) << "1 mm of noise, and a little clutter";
    EXPECT_EQ (plane.moments.count, static_cast<double> (plane.inliers.size()));
    const auto fit = fitPlane (plane.moments);
    ASSERT_TRUE (fit);
    EXPECT_LT (angleBetween (fit->plane.normal, plane.normal), 1e-6);
  }
}

TEST_P (Contract, NamesTheOrientationOfEachPlane)
{
  using pcl_ops::Orientation;
  Ops ops = detectorFor (Scene()
                             .floor (3, 3)
                             .wall ({0, 0}, {2, 0}, 2.5)
                             .surface ({5, 0, 0}, {1.4, 0, 1.4}, {0, 1.5, 0})
                             .build()
                             .cloud);
  const auto planes = planesOf (ops);
  ASSERT_EQ (planes.size(), 3u);
  EXPECT_EQ (planes[0].orientation, Orientation::Horizontal);
  EXPECT_EQ (planes[1].orientation, Orientation::Vertical);
  EXPECT_EQ (planes[2].orientation, Orientation::Other);
}

TEST_P (Contract, WorksOnALargeCloudThenASmallOneThenALargeOne)
{
  Ops ops = detectorFor (nullptr);
  std::vector<PlaneSegment> planes;
  EXPECT_FALSE (ops.segment (planes)) << "without a cloud first";
  const auto large = room().build(), small = Scene().floor (1.5, 1.5).build();
  for (const auto& scene : {large, small, large}) {
    ops.setInputCloud (scene.cloud);
    expectFindsEverySurface (planesOf (ops), scene);
  }
}

TEST_P (Contract, TwoObjectsWorkInTwoThreads)
{
  const auto scene = room().build();
  Ops first = detectorFor (scene.cloud), second = detectorFor (scene.cloud);
  first.setNumberOfThreads (2);
  std::vector<pcl::Indices> of_first, of_second;
  std::thread other ([&] { of_second = inliersOf (second); });
  of_first = inliersOf (first);
  other.join();
  EXPECT_EQ (of_first, of_second);
  EXPECT_EQ (of_first.size(), 3u);
}
