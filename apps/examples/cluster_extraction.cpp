// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause

// PCL's tutorial on cluster extraction, done twice. The first time a loop of
// SACSegmentation removes the planes one by one, as in the tutorial. The second time
// one call of pcl_ops replaces the loop. Prints the duration of both. Lengths [m] and
// other numbers are those of the tutorial.
#include <pcl/common/time.h>
#include <pcl/filters/extract_indices.h>
#include <pcl/filters/voxel_grid.h>
#include <pcl/io/pcd_io.h>
#include <pcl/segmentation/extract_clusters.h>
#include <pcl/segmentation/sac_segmentation.h>

#include <pcl_ops/oriented_point_sampling.h>

#include <iostream>

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

/** \brief Returns one point, the mean, for each voxel with points. */
static Cloud::Ptr
downsampled (const Cloud::Ptr& cloud)
{
  pcl::VoxelGrid<pcl::PointXYZ> grid;
  grid.setInputCloud (cloud);
  grid.setLeafSize (0.01f, 0.01f, 0.01f);
  Cloud::Ptr thinned (new Cloud);
  grid.filter (*thinned);
  return thinned;
}

/** \brief Returns the cloud without the points of these indices. */
static Cloud::Ptr
without (const pcl::Indices& removed, const Cloud::Ptr& cloud)
{
  pcl::ExtractIndices<pcl::PointXYZ> extraction;
  extraction.setInputCloud (cloud);
  extraction.setIndices (pcl::make_shared<pcl::Indices> (removed));
  extraction.setNegative (true);
  Cloud::Ptr rest (new Cloud);
  extraction.filter (*rest);
  return rest;
}

/** \brief Returns clusters of points that are near each other. */
static std::vector<pcl::PointIndices>
clustersOf (const Cloud::Ptr& cloud)
{
  pcl::EuclideanClusterExtraction<pcl::PointXYZ> extraction;
  extraction.setClusterTolerance (0.02);
  extraction.setMinClusterSize (100);
  extraction.setMaxClusterSize (25000);
  extraction.setInputCloud (cloud);
  std::vector<pcl::PointIndices> clusters;
  extraction.extract (clusters);
  return clusters;
}

/** \brief Returns the points that remain when the loop of the tutorial has removed
 * planes.
 * \param[out] planes number of removed planes */
static Cloud::Ptr
restByLoop (const Cloud::Ptr& cloud, std::size_t& planes)
{
  constexpr double max_rest = 0.3; // the loop ends at this share of the cloud's points
  pcl::SACSegmentation<pcl::PointXYZ> finder;
  finder.setOptimizeCoefficients (true);
  finder.setModelType (pcl::SACMODEL_PLANE);
  finder.setMethodType (pcl::SAC_RANSAC);
  finder.setMaxIterations (100);
  finder.setDistanceThreshold (0.02);
  pcl::ModelCoefficients coefficients;
  pcl::PointIndices plane;
  Cloud::Ptr rest = cloud;
  for (planes = 0; rest->size() > max_rest * cloud->size(); ++planes) {
    finder.setInputCloud (rest);
    finder.segment (plane, coefficients);
    if (plane.indices.empty())
      break;
    rest = without (plane.indices, rest);
  }
  return rest;
}

/** \brief Returns the points on no plane, by one call of pcl_ops.
 * \param[out] planes number of planes */
static Cloud::Ptr
restByOps (const Cloud::Ptr& cloud, std::size_t& planes)
{
  pcl_ops::OrientedPointSampling<pcl::PointXYZ> ops;
  ops.setInputCloud (cloud);
  std::vector<pcl::PointIndices> points_of_planes;
  ops.extract (points_of_planes);
  planes = points_of_planes.size();
  pcl::Indices on_planes;
  for (const pcl::PointIndices& plane : points_of_planes)
    on_planes.insert (on_planes.end(), plane.indices.begin(), plane.indices.end());
  return without (on_planes, cloud);
}

int
main (int argc, char** argv)
{
  const Cloud::Ptr cloud (new Cloud);
  if (argc != 2 || pcl::io::loadPCDFile (argv[1], *cloud) < 0) {
    std::cerr << "Usage: cluster_extraction CLOUD.pcd\n";
    return 2;
  }
  const Cloud::Ptr points = downsampled (cloud);
  for (const bool by_loop : {true, false}) {
    std::size_t planes = 0;
    const pcl::StopWatch watch;
    const Cloud::Ptr rest = (by_loop ? restByLoop : restByOps) (points, planes);
    std::cout << (by_loop ? "loop: " : "pcl_ops: ") << watch.getTime() << " ms, "
              << planes << " planes, the other " << rest->size() << " points in "
              << clustersOf (rest).size() << " clusters\n";
  }
}
