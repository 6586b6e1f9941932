// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/common/angles.h>
#include <pcl/common/point_tests.h>
#include <pcl/common/transforms.h>
#include <pcl/features/integral_image_normal.h>
#include <pcl/features/normal_3d.h>
#include <pcl/search/kdtree.h>
#include <pcl/segmentation/organized_multi_plane_segmentation.h>
#include <pcl/segmentation/region_growing.h>
#include <pcl/segmentation/sac_segmentation.h>

#include "peers.h"

#include <algorithm>

namespace pcl_ops::evaluation {

namespace {

constexpr int max_iterations = 1000;
/** As in PCL's tutorial: the normals alone decide. */
constexpr float curvature_threshold = 1.0f;
constexpr int min_points_of_region = 50;

using Normals = pcl::PointCloud<pcl::Normal>;

Normals::Ptr
normalsOf (const PeerTask& task, const pcl::search::KdTree<pcl::PointXYZ>::Ptr& tree)
{
  Normals::Ptr normals (new Normals);
  pcl::NormalEstimation<pcl::PointXYZ, pcl::Normal> estimation;
  estimation.setInputCloud (task.cloud);
  estimation.setSearchMethod (tree);
  estimation.setKSearch (task.values.neighbors);
  estimation.compute (*normals);
  return normals;
}

/** The image of a depth camera, in its axes, as what reads it expects. */
XyzCloud::Ptr
inAxesOfCamera (const XyzCloud& image)
{
  const Eigen::Isometry3f to_scene =
      Eigen::Translation3f (image.sensor_origin_.head<3>()) * image.sensor_orientation_;
  const Eigen::Isometry3f to_camera = to_scene.inverse();
  XyzCloud::Ptr seen (new XyzCloud (image.width, image.height));
  seen->is_dense = false;
  for (std::size_t i = 0; i < image.size(); ++i)
    (*seen)[i].getVector3fMap() = to_camera * image[i].getVector3fMap();
  return seen;
}

Normals::Ptr
normalsOfImage (const XyzCloud::ConstPtr& image)
{
  // As in PCL's demo of OrganizedMultiPlaneSegmentation.
  constexpr float max_depth_change = 0.03f, smoothing = 20.0f;
  Normals::Ptr normals (new Normals);
  pcl::IntegralImageNormalEstimation<pcl::PointXYZ, pcl::Normal> estimation;
  estimation.setNormalEstimationMethod (estimation.COVARIANCE_MATRIX);
  estimation.setMaxDepthChangeFactor (max_depth_change);
  estimation.setNormalSmoothingSize (smoothing);
  estimation.setInputCloud (image);
  estimation.compute (*normals);
  return normals;
}

} // namespace

std::vector<pcl::PointIndices>
planesByPclRansac (const PeerTask& task)
{
  pcl::SACSegmentation<pcl::PointXYZ> segmentation;
  segmentation.setOptimizeCoefficients (true);
  segmentation.setModelType (pcl::SACMODEL_PLANE);
  segmentation.setMethodType (pcl::SAC_RANSAC);
  segmentation.setMaxIterations (max_iterations);
  segmentation.setDistanceThreshold (task.values.threshold);
  segmentation.setInputCloud (task.cloud);
  return peelPlanes (task.cloud->size(), [&] (const pcl::IndicesPtr& rest) {
    pcl::PointIndices inliers;
    pcl::ModelCoefficients coefficients;
    segmentation.setIndices (rest);
    segmentation.segment (inliers, coefficients);
    std::sort (inliers.indices.begin(), inliers.indices.end());
    return inliers.indices;
  });
}

std::vector<pcl::PointIndices>
planesByPclRegionGrowing (const PeerTask& task)
{
  pcl::search::KdTree<pcl::PointXYZ>::Ptr tree (new pcl::search::KdTree<pcl::PointXYZ>);
  const auto normals =
      timed (task.normals, task.settings.clock, [&] { return normalsOf (task, tree); });
  pcl::RegionGrowing<pcl::PointXYZ, pcl::Normal> growing;
  growing.setInputCloud (task.cloud);
  growing.setInputNormals (normals);
  growing.setSearchMethod (tree);
  growing.setNumberOfNeighbours (unsigned (task.values.neighbors));
  growing.setSmoothnessThreshold (float (paper_angle_tolerance));
  growing.setCurvatureThreshold (curvature_threshold);
  growing.setMinClusterSize (min_points_of_region);
  std::vector<pcl::PointIndices> regions;
  growing.extract (regions);
  return regions;
}

std::vector<pcl::PointIndices>
planesInImage (const PeerTask& task)
{
  // What PCL's demo of it takes.
  const double angle = pcl::deg2rad (2.0);
  constexpr double usual_distance = 0.02; // [m]
  const XyzCloud::Ptr image = inAxesOfCamera (*task.settings.image);
  const auto normals =
      timed (task.normals, task.settings.clock, [&] { return normalsOfImage (image); });
  pcl::OrganizedMultiPlaneSegmentation<pcl::PointXYZ, pcl::Normal, pcl::Label> finder;
  finder.setMinInliers (min_points_of_region);
  finder.setAngularThreshold (angle);
  finder.setDistanceThreshold (
      task.source == ValuesFrom::Tutorial ? usual_distance : task.values.threshold);
  finder.setInputNormals (normals);
  finder.setInputCloud (image);
  std::vector<pcl::PlanarRegion<pcl::PointXYZ>,
              Eigen::aligned_allocator<pcl::PlanarRegion<pcl::PointXYZ>>>
      regions;
  std::vector<pcl::ModelCoefficients> models;
  std::vector<pcl::PointIndices> planes, of_labels, borders;
  pcl::PointCloud<pcl::Label>::Ptr labels (new pcl::PointCloud<pcl::Label>);
  finder.segmentAndRefine (regions, models, planes, labels, of_labels, borders);
  pcl::Indices point_of (image->size(), 0);
  pcl::index_t points = 0;
  for (std::size_t i = 0; i < image->size(); ++i)
    point_of[i] = pcl::isXYZFinite ((*image)[i]) ? points++ : 0;
  for (pcl::PointIndices& plane : planes)
    for (pcl::index_t& i : plane.indices)
      i = point_of[i];
  return planes;
}

} // namespace pcl_ops::evaluation
