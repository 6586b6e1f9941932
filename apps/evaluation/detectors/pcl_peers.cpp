// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/common/angles.h>
#include <pcl/features/normal_3d.h>
#include <pcl/search/kdtree.h>
#include <pcl/segmentation/region_growing.h>
#include <pcl/segmentation/sac_segmentation.h>

#include "detector_run.h"

#include <algorithm>
#include <iterator>
#include <numeric>

namespace pcl_ops::evaluation {

namespace {

constexpr double distance_threshold = 0.05; // [m]
constexpr int max_planes = 40;
constexpr std::size_t min_inliers = 500;
/** The loop ends when less than this share of the points is left. */
constexpr double share_left = 0.02;
constexpr int max_iterations = 1000;

constexpr int neighbors = 30;
/** As in PCL's tutorial: the normals alone decide. */
constexpr float curvature_threshold = 1.0f;
constexpr int min_points_of_region = 50;

std::vector<pcl::PointIndices>
planesByRansac (const XyzCloud::ConstPtr& cloud)
{
  pcl::SACSegmentation<pcl::PointXYZ> segmentation;
  segmentation.setOptimizeCoefficients (true);
  segmentation.setModelType (pcl::SACMODEL_PLANE);
  segmentation.setMethodType (pcl::SAC_RANSAC);
  segmentation.setMaxIterations (max_iterations);
  segmentation.setDistanceThreshold (distance_threshold);
  segmentation.setInputCloud (cloud);

  std::vector<pcl::PointIndices> planes;
  pcl::IndicesPtr rest (new pcl::Indices (cloud->size()));
  std::iota (rest->begin(), rest->end(), 0);
  while (rest->size() > share_left * cloud->size() && planes.size() < max_planes) {
    pcl::PointIndices inliers;
    pcl::ModelCoefficients coefficients;
    segmentation.setIndices (rest);
    segmentation.segment (inliers, coefficients);
    if (inliers.indices.size() < min_inliers)
      break;
    std::sort (inliers.indices.begin(), inliers.indices.end());
    pcl::IndicesPtr without (new pcl::Indices);
    std::set_difference (rest->begin(),
                         rest->end(),
                         inliers.indices.begin(),
                         inliers.indices.end(),
                         std::back_inserter (*without));
    rest = without;
    planes.push_back (inliers);
  }
  return planes;
}

pcl::PointCloud<pcl::Normal>::Ptr
normalsOf (const XyzCloud::ConstPtr& cloud,
           const pcl::search::KdTree<pcl::PointXYZ>::Ptr& tree)
{
  pcl::PointCloud<pcl::Normal>::Ptr normals (new pcl::PointCloud<pcl::Normal>);
  pcl::NormalEstimation<pcl::PointXYZ, pcl::Normal> estimation;
  estimation.setInputCloud (cloud);
  estimation.setSearchMethod (tree);
  estimation.setKSearch (neighbors);
  estimation.compute (*normals);
  return normals;
}

std::vector<pcl::PointIndices>
regionsOf (const XyzCloud::ConstPtr& cloud, double& normals_duration)
{
  pcl::search::KdTree<pcl::PointXYZ>::Ptr tree (new pcl::search::KdTree<pcl::PointXYZ>);
  const auto normals =
      timed (normals_duration, [&] { return normalsOf (cloud, tree); });
  pcl::RegionGrowing<pcl::PointXYZ, pcl::Normal> growing;
  growing.setInputCloud (cloud);
  growing.setInputNormals (normals);
  growing.setSearchMethod (tree);
  growing.setNumberOfNeighbours (neighbors);
  growing.setSmoothnessThreshold (static_cast<float> (paper_angle));
  growing.setCurvatureThreshold (curvature_threshold);
  growing.setMinClusterSize (min_points_of_region);
  std::vector<pcl::PointIndices> regions;
  growing.extract (regions);
  return regions;
}

} // namespace

void
addPclPeers (std::vector<Configuration>& configurations)
{
  configurations.push_back (
      {"pcl-sac",
       {"peers"},
       [] (const XyzCloud::ConstPtr& cloud, const Eigen::Vector3d&, std::uint32_t) {
         return runPeer (*cloud, [&] (double&) { return planesByRansac (cloud); });
       }});
  configurations.push_back (
      {"pcl-region-growing",
       {"peers"},
       [] (const XyzCloud::ConstPtr& cloud, const Eigen::Vector3d&, std::uint32_t) {
         return runPeer (*cloud,
                         [&] (double& normals) { return regionsOf (cloud, normals); });
       }});
}

} // namespace pcl_ops::evaluation
