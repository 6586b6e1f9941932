// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The steps of PCL's tutorial on cluster extraction, with its numbers [m].
#include <pcl/filters/extract_indices.h>
#include <pcl/filters/voxel_grid.h>
#include <pcl/segmentation/extract_clusters.h>
#include <pcl/segmentation/sac_segmentation.h>

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

inline Cloud::Ptr
downsampled (const Cloud::Ptr& cloud)
{
  pcl::VoxelGrid<pcl::PointXYZ> grid;
  grid.setInputCloud (cloud);
  grid.setLeafSize (0.01f, 0.01f, 0.01f);
  Cloud::Ptr points (new Cloud);
  grid.filter (*points);
  return points;
}

inline Cloud::Ptr
without (const pcl::Indices& points, const Cloud::Ptr& cloud)
{
  pcl::ExtractIndices<pcl::PointXYZ> extraction;
  extraction.setInputCloud (cloud);
  extraction.setIndices (pcl::make_shared<pcl::Indices> (points));
  extraction.setNegative (true);
  Cloud::Ptr rest (new Cloud);
  extraction.filter (*rest);
  return rest;
}

inline pcl::SACSegmentation<pcl::PointXYZ>
planeFinder ()
{
  pcl::SACSegmentation<pcl::PointXYZ> finder;
  finder.setOptimizeCoefficients (true);
  finder.setModelType (pcl::SACMODEL_PLANE);
  finder.setMethodType (pcl::SAC_RANSAC);
  finder.setMaxIterations (100);
  finder.setDistanceThreshold (0.02);
  return finder;
}

inline std::vector<pcl::PointIndices>
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
