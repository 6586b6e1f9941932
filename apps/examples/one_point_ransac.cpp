// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause

// Uses the plane model for one oriented point (a point with its normal) in PCL's RANSAC
// and PROSAC.
#include <pcl/common/io.h>
#include <pcl/features/normal_3d.h>
#include <pcl/filters/voxel_grid.h>
#include <pcl/io/pcd_io.h>
#include <pcl/sample_consensus/prosac.h>
#include <pcl/sample_consensus/ransac.h>

#include <pcl_ops/sac_model_oriented_point.h>

#include <algorithm>
#include <iostream>

using Point = pcl::PointNormal;
using Model = pcl_ops::SampleConsensusModelOrientedPoint<Point>;

/** \brief Finds the largest plane and prints it. */
static void
printPlane (const char* name, pcl::SampleConsensus<Point>&& estimator)
{
  estimator.computeModel();
  estimator.refineModel();
  pcl::Indices inliers;
  estimator.getInliers (inliers);
  Eigen::VectorXf abcd;
  estimator.getModelCoefficients (abcd);
  std::cout << name << ": " << inliers.size() << " points, a b c d " << abcd.transpose()
            << "\n";
}

int
main (int argc, char** argv)
{
  const pcl::PointCloud<pcl::PointXYZ>::Ptr points (new pcl::PointCloud<pcl::PointXYZ>);
  if (argc != 2 || pcl::io::loadPCDFile (argv[1], *points) < 0)
    return std::cerr << "Usage: one_point_ransac CLOUD.pcd\n", 2;
  pcl::VoxelGrid<pcl::PointXYZ> grid;
  grid.setLeafSize (0.03f, 0.03f, 0.03f); // [m]
  grid.setInputCloud (points);
  grid.filter (*points);
  const pcl::PointCloud<Point>::Ptr cloud (new pcl::PointCloud<Point>);
  pcl::copyPointCloud (*points, *cloud);
  pcl::NormalEstimation<pcl::PointXYZ, Point> normals;
  normals.setInputCloud (points);
  normals.setKSearch (30); // neighbors
  normals.compute (*cloud);

  const Model::Ptr all (new Model (cloud));
  // PROSAC draws from the front of the indices. Flat neighborhoods come first, as they
  // have the best normals.
  pcl::Indices by_flatness = *all->getIndices();
  std::sort (by_flatness.begin(), by_flatness.end(), [&] (auto a, auto b) {
    return (*cloud)[a].curvature < (*cloud)[b].curvature;
  });
  const Model::Ptr flattest_first (new Model (cloud, by_flatness));
  constexpr double max_distance = 0.05; // of inliers to the plane [m]
  printPlane ("RANSAC", pcl::RandomSampleConsensus<Point> (all, max_distance));
  printPlane ("PROSAC",
              pcl::ProgressiveSampleConsensus<Point> (flattest_first, max_distance));
}
