// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <pcl_ops/oriented_point_sampling.h>

#include <cstdio>

// A floor and a wall of 2 m x 2 m, which meet at an edge.
static pcl::PointCloud<pcl::PointXYZ>::Ptr
floorAndWall ()
{
  constexpr float spacing = 0.02f; // [m]
  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud (new pcl::PointCloud<pcl::PointXYZ>);
  for (int row = 0; row < 100; ++row)
    for (int column = 0; column < 100; ++column) {
      const float from_edge = spacing * static_cast<float> (row + 1);
      const float along_edge = spacing * static_cast<float> (column);
      cloud->push_back ({from_edge, along_edge, 0.0f});
      cloud->push_back ({0.0f, along_edge, from_edge});
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
