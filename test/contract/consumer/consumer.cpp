// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <pcl_ops/oriented_point_sampling.h>

#include <cstdio>

// Two meters of floor and two meters of wall, a point every 2 cm.
static pcl::PointCloud<pcl::PointXYZ>::Ptr
floorAndWall ()
{
  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud (new pcl::PointCloud<pcl::PointXYZ>);
  for (int row = 0; row < 100; ++row)
    for (int column = 0; column < 100; ++column) {
      const float a = 0.02f * static_cast<float> (row + 1);
      const float b = 0.02f * static_cast<float> (column);
      cloud->push_back ({a, b, 0.0f});
      cloud->push_back ({0.0f, b, a});
    }
  return cloud;
}

int
main ()
{
  pcl_ops::OrientedPointSampling<pcl::PointXYZ> ops;
  ops.setInputCloud (floorAndWall());
  std::vector<pcl::ModelCoefficients> coefficients;
  std::vector<pcl::PointIndices> inliers;
  const bool succeeded = ops.segment (coefficients, inliers);
  std::printf ("%zu planes\n", inliers.size());
  return succeeded && inliers.size() == 2 ? 0 : 1;
}
