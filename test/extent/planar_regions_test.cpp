// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "presets.h"
#include "scene.h"
#include <pcl_ops/plane_extent.h>

TEST (PlanarRegions, AreThePlanesWithTheirHullsAsContours)
{
  const auto scene = room().build();
  Ops detector;
  detector.setInputCloud (scene.cloud);
  std::vector<pcl_ops::PlaneSegment> planes;
  Ops::PlanarRegions regions;
  ASSERT_TRUE (detector.segment (planes));
  ASSERT_TRUE (detector.segment (regions));
  ASSERT_EQ (regions.size(), planes.size());
  for (std::size_t i = 0; i < planes.size(); ++i) {
    Eigen::Vector4d coefficients;
    coefficients << planes[i].normal, planes[i].plane().offset;
    EXPECT_TRUE (regions[i].getCoefficients().isApprox (coefficients.cast<float>()));
    EXPECT_TRUE (regions[i].getCentroid().isApprox (planes[i].centroid.cast<float>()));
    EXPECT_TRUE (regions[i].getCovariance().isApprox (
        planes[i].moments.covariance().cast<float>()));
    EXPECT_EQ (regions[i].getCount(), planes[i].inliers.size());
    const auto hull = pcl_ops::planeExtent (*scene.cloud, planes[i]).hull;
    const auto& contour = regions[i].getContour();
    ASSERT_EQ (contour.size(), hull.size());
    for (std::size_t k = 0; k < hull.size(); ++k)
      EXPECT_TRUE (contour[k].getVector3fMap().isApprox (hull[k].cast<float>()));
  }
}
