// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
// PCL's libraries have no code for a point type of the user's own. This macro makes the
// headers include the bodies of PCL's templates.
#define PCL_NO_PRECOMPILE
#include "scene.h"
#include <pcl_ops/oriented_point_sampling.h>

struct ThermalPoint {
  PCL_ADD_POINT4D;
  float temperature;
  PCL_MAKE_ALIGNED_OPERATOR_NEW
};

TEST (CustomPointType, IsTheTypeOfTheCloudAndOfTheContoursOfItsRegions)
{
  const LabeledScene scene = room().build();
  const auto cloud = pcl::make_shared<pcl::PointCloud<ThermalPoint>>();
  for (const pcl::PointXYZ& point : *scene.cloud) {
    ThermalPoint thermal{};
    thermal.getVector3fMap() = point.getVector3fMap();
    cloud->push_back (thermal);
  }
  pcl_ops::OrientedPointSampling<ThermalPoint> ops;
  ops.setInputCloud (cloud);
  ops.setSamplingRate (0.1);
  std::vector<pcl_ops::PlaneSegment> planes;
  ASSERT_TRUE (ops.segment (planes));
  expectFindsEverySurface (planes, scene);
  decltype (ops)::PlanarRegions regions;
  ASSERT_TRUE (ops.segment (regions));
  ASSERT_EQ (regions.size(), scene.surfaces.size());
  for (const pcl::PlanarRegion<ThermalPoint>& region : regions) {
    EXPECT_GE (region.getContour().size(), 4u);
    for (const ThermalPoint& corner : region.getContour())
      EXPECT_NEAR (region.getCoefficients().dot (corner.getVector4fMap()), 0.0f, 1e-4f)
          << "distance from the plane [m]";
  }
}
