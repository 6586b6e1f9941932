// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause

// Finds all planes of a cloud and prints their equations.
#include <pcl/io/pcd_io.h>

#include <pcl_ops/oriented_point_sampling.h>

#include <cstdio>

int
main (int argc, char** argv)
{
  using Cloud = pcl::PointCloud<pcl::PointXYZ>;
  const Cloud::Ptr cloud (new Cloud);
  if (argc != 2 || pcl::io::loadPCDFile (argv[1], *cloud) < 0) {
    std::fprintf (stderr, "Usage: minimal CLOUD.pcd\n");
    return 2;
  }

  pcl_ops::OrientedPointSampling<pcl::PointXYZ> ops;
  ops.setInputCloud (cloud);
  std::vector<pcl::ModelCoefficients> coefficients;
  std::vector<pcl::PointIndices> inliers;
  if (!ops.segment (coefficients, inliers))
    return 1;

  for (std::size_t plane = 0; plane < inliers.size(); ++plane) {
    const std::vector<float>& abcd = coefficients[plane].values;
    std::printf ("%6zu points on %.3f x + %.3f y + %.3f z + %.3f = 0\n",
                 inliers[plane].indices.size(),
                 abcd[0],
                 abcd[1],
                 abcd[2],
                 abcd[3]);
  }
  std::printf ("%zu planes\n", inliers.size());
}
