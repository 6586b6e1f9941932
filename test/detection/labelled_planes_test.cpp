// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "detection/labelled_planes.h"
#include "grid_scene.h"

using namespace pcl_ops;
using namespace pcl_ops::internal;

TEST (MergeAssigned, FitsThePlanesToTheirPointsAndRelabelsThem)
{
  // Plane 0 is a line, 1 and 2 are two halves of one floor, and a point is on none.
  Points points;
  for (int i = 0; i < 10; ++i)
    points.add (static_cast<float> (i), 7.0f, 7.0f);
  for (int i = 0; i < 100; ++i)
    points.add (static_cast<float> (i % 10), static_cast<float> (i / 10), 0.0f);
  Labels labels (110, 2), expected (110, 0);
  std::fill_n (labels.begin(), 10, 0);
  std::fill_n (labels.begin() + 10, 50, 1);
  std::fill_n (expected.begin(), 10, no_plane);
  labels.back() = expected.back() = no_plane;
  MergingParameters merging;
  merging.distance_threshold = 5_cm;
  const LabelledPlanes found =
      mergeAssigned ({labels, momentsOfLabels (points, labels, 3, 1)}, merging, 2);
  EXPECT_EQ (found.labels, expected);
  EXPECT_EQ (found.planes_before_merging, 3u);
  ASSERT_EQ (found.planes.fits.size(), 1u);
  EXPECT_NEAR (std::abs (found.planes.fits[0].plane.normal.z()), 1.0, 1e-9);
  EXPECT_EQ (found.planes.moments[0].count, 99.0);
}

TEST (DetectInFinitePoints, RunsNoStageWithoutAFinitePoint)
{
  pcl::PointCloud<pcl::PointXYZ> cloud;
  cloud.push_back ({NAN, 0, 0});
  const DetectorInput input{
      pcl_ops::CloudView (cloud), nullptr, Eigen::Vector3d::Zero(), nullptr};
  const auto detect = [] (const Points&, auto&) {
    ADD_FAILURE() << "called";
    return LabelledPlanes();
  };
  EXPECT_TRUE (
      detectInFinitePoints (input, PlaneDetectorParameters(), detect).planes.empty());
}

TEST (MergingOf, TakesThetaHWhereMergingHasNoDistanceOfItsOwn)
{
  PlaneDetectorParameters parameters;
  parameters.distance_threshold = 7_cm;
  EXPECT_EQ (mergingOf (parameters).distance_threshold, 7_cm);
  parameters.merging.distance_threshold = 1_cm;
  EXPECT_EQ (mergingOf (parameters).distance_threshold, 1_cm);
}
