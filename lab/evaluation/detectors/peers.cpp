// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "peers.h"

#include <pcl/common/angles.h>
#include <pcl/common/point_tests.h>
#include <pcl/features/integral_image_normal.h>
#include <pcl/features/normal_3d.h>
#include <pcl/search/kdtree.h>
#include <pcl/segmentation/organized_multi_plane_segmentation.h>
#include <pcl/segmentation/region_growing.h>
#include <pcl/segmentation/sac_segmentation.h>
#include <pcl/pcl_config.h>

#include <numbers/statistics.h>
#include <pcl_ops/oriented_point_sampling.h>
#ifdef PCL_OPS_WITH_CGAL
#include <CGAL/version.h>
#endif
#ifdef PCL_OPS_WITH_OPEN3D
#include <open3d/Open3DConfig.h>
#endif

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

namespace pcl_ops::evaluation {

namespace {

/** Distance threshold of a peer, in multiples of the noise: 99.7 % of the points of a
 * plane with normally distributed noise are within it. */
constexpr double threshold_in_noises = 3.0;

/** Returns the rms distance of inliers to their planes, as found by the default preset
 * of OPS; a third of the usual threshold if it finds no plane [m]. */
double
noiseOf (const XyzCloud::ConstPtr& cloud)
{
  OrientedPointSampling<pcl::PointXYZ> ops;
  ops.setInputCloud (cloud);
  std::vector<PlaneSegment> planes;
  ops.segment (planes);
  double sum_of_squares = 0.0;
  double points = 0.0;
  for (const PlaneSegment& plane : planes)
    if (const std::optional<PlaneFit> fit = fitPlane (plane.moments)) {
      sum_of_squares += plane.moments.count * fit->variances[0];
      points += plane.moments.count;
    }
  return points > 0.0 ? std::sqrt (sum_of_squares / points)
                      : usual_peer_threshold / threshold_in_noises;
}

/** Returns the median over sampled points of the point spacing: the distance between
 * neighbors if the points were spread evenly on a plane [m]. */
double
spacingOf (const XyzCloud::ConstPtr& cloud)
{
  // Chosen by hand: neighbors, of which the point itself is one, and the number of
  // points at most.
  constexpr int neighbors = 30;
  constexpr std::size_t samples = 2000;
  pcl::search::KdTree<pcl::PointXYZ> tree;
  tree.setInputCloud (cloud);
  std::vector<double> spacings;
  pcl::Indices found;
  std::vector<float> squared_distances;
  const std::size_t stride = cloud->size() / samples + 1;
  for (std::size_t i = 0; i < cloud->size(); i += stride) {
    tree.nearestKSearch ((*cloud)[i], neighbors, found, squared_distances);
    // The square root of the area per neighbor in the disk that holds the neighbors.
    spacings.push_back (
        std::sqrt (M_PI * squared_distances.back() / double (found.size())));
  }
  return apps::quantile (spacings, 0.5);
}

/** Default number of points of the smallest plane, for detectors without
 * \ref peelPlanes. */
constexpr std::size_t min_points_of_region = 50;

using Normals = pcl::PointCloud<pcl::Normal>;

/** Returns an image in the frame of its camera, as PCL's image detectors expect. */
XyzCloud::Ptr
inCameraFrame (const XyzCloud& image)
{
  const Eigen::Isometry3f to_scene =
      Eigen::Translation3f (image.sensor_origin_.head<3>()) * image.sensor_orientation_;
  const Eigen::Isometry3f to_camera = to_scene.inverse();
  XyzCloud::Ptr in_camera (new XyzCloud (image.width, image.height));
  in_camera->is_dense = false;
  for (std::size_t i = 0; i < image.size(); ++i)
    (*in_camera)[i].getVector3fMap() = to_camera * image[i].getVector3fMap();
  return in_camera;
}

} // namespace

PeerValues
valuesFor (const XyzCloud::ConstPtr& cloud,
           const RunSettings& settings,
           ValuesFrom source)
{
  const double threshold = settings.peer_threshold;
  constexpr int default_neighbors = 30;
  PeerValues values{threshold,
                    settings.peer_neighbors.value_or (default_neighbors),
                    2.0 * threshold,
                    threshold / threshold_in_noises};
  if (source == ValuesFrom::Tutorial || cloud->empty())
    return values;
  const double spacing = spacingOf (cloud);
  if (!(spacing > 0.0)) // most points coincide
    return values;
  values.noise = settings.peer_noise ? *settings.peer_noise : noiseOf (cloud);
  // Exact points have no noise, but need a threshold above 0.
  values.threshold = std::max (threshold_in_noises * values.noise, 0.1 * spacing);
  values.gap = std::max (values.threshold, 4.0 * spacing);
  // A plane through k points spread evenly over a disk of radius r errs by an angle of
  // 2 noise / (r sqrt (k)), and r = spacing sqrt (k / pi).
  constexpr double error_of_normal = 3.0 * M_PI / 180.0; // [rad]
  constexpr double max_neighbors = 200;
  const double neighbors =
      2.0 * std::sqrt (M_PI) * values.noise / (spacing * error_of_normal);
  if (!settings.peer_neighbors)
    values.neighbors =
        int (std::clamp<double> (neighbors, values.neighbors, max_neighbors));
  return values;
}

namespace {

struct Peer {
  std::string name;
  std::string version; // name and version of its project; empty: it is in this project
  Planes (*detect) (const PeerTask& task);
  bool needs_image = false;
};

std::vector<Peer>
allPeers ()
{
  const std::string of_pcl = "PCL " PCL_VERSION_PRETTY;
  std::vector<Peer> peers{{"pcl-sac", of_pcl, planesByPclRansac},
                          {"pcl-region-growing", of_pcl, planesByPclRegionGrowing},
                          {"pcl-organized", of_pcl, planesInImage, true},
                          {"voxel-octree", "", planesInVoxelOctree}};
#ifdef PCL_OPS_WITH_CGAL
  const std::string of_cgal = "CGAL " CGAL_VERSION_STR;
  peers.push_back ({"cgal-ransac", of_cgal, planesByCgalRansac});
  peers.push_back ({"cgal-region-growing", of_cgal, planesByCgalRegionGrowing});
#endif
#ifdef PCL_OPS_WITH_OPEN3D
  peers.push_back ({"open3d", "Open3D " OPEN3D_VERSION, planesByOpen3d});
#endif
  return peers;
}

DetectorRun
runPeer (const Peer& peer,
         ValuesFrom source,
         const XyzCloud::ConstPtr& cloud,
         const RunSettings& settings)
{
  const PeerValues values = valuesFor (cloud, settings, source);
  DetectorRun run;
  timed (run.durations.detection, [&] {
    const Planes planes =
        peer.detect ({cloud, settings, values, source, run.durations.normals});
    run.planes_before_merging = planes.size();
    run.labels = labelsOf (planes, cloud->size());
  });
  return run;
}

} // namespace

void
addPeers (std::vector<Configuration>& configurations)
{
  for (const Peer& peer : allPeers())
    for (const ValuesFrom source : {ValuesFrom::Tutorial, ValuesFrom::Cloud}) {
      const std::string suffix = source == ValuesFrom::Cloud ? "-measured" : "";
      Configuration configuration;
      configuration.name = peer.name + suffix;
      configuration.groups = {"peers" + suffix};
      configuration.run = [peer, source] (const XyzCloud::ConstPtr& cloud,
                                          const RunSettings& settings) {
        return runPeer (peer, source, cloud, settings);
      };
      configuration.is_peer = true;
      configuration.needs_image = peer.needs_image;
      configuration.version = peer.version;
      configurations.push_back (configuration);
    }
}

Planes
peelPlanes (const PeerTask& task,
            const std::function<pcl::Indices (const pcl::IndicesPtr& rest)>& segment)
{
  // Chosen by hand.
  constexpr std::size_t max_planes = 40;
  constexpr std::size_t default_min_inliers = 500;
  constexpr double rest_share_at_end = 0.02; // of the points of the cloud
  const std::size_t min_inliers = task.minPoints (default_min_inliers);
  const std::size_t points = task.cloud->size();
  Planes planes;
  pcl::IndicesPtr rest (new pcl::Indices (points));
  std::iota (rest->begin(), rest->end(), 0);
  while (double (rest->size()) > rest_share_at_end * double (points) &&
         planes.size() < max_planes) {
    pcl::PointIndices plane;
    plane.indices = segment (rest);
    if (plane.indices.size() < min_inliers)
      break;
    pcl::IndicesPtr new_rest (new pcl::Indices);
    std::set_difference (rest->begin(),
                         rest->end(),
                         plane.indices.begin(),
                         plane.indices.end(),
                         std::back_inserter (*new_rest));
    rest = new_rest;
    planes.push_back (plane);
  }
  return planes;
}

Planes
planesByPclRansac (const PeerTask& task)
{
  constexpr int iterations = 1000; // as in PCL's tutorial
  pcl::SACSegmentation<pcl::PointXYZ> segmentation;
  segmentation.setOptimizeCoefficients (true);
  segmentation.setModelType (pcl::SACMODEL_PLANE);
  segmentation.setMethodType (pcl::SAC_RANSAC);
  segmentation.setMaxIterations (iterations);
  segmentation.setDistanceThreshold (task.values.threshold);
  segmentation.setInputCloud (task.cloud);
  return peelPlanes (task, [&] (const pcl::IndicesPtr& rest) {
    pcl::PointIndices inliers;
    pcl::ModelCoefficients coefficients;
    segmentation.setIndices (rest);
    segmentation.segment (inliers, coefficients);
    std::sort (inliers.indices.begin(), inliers.indices.end());
    return inliers.indices;
  });
}

Planes
planesByPclRegionGrowing (const PeerTask& task)
{
  pcl::search::KdTree<pcl::PointXYZ>::Ptr tree (new pcl::search::KdTree<pcl::PointXYZ>);
  const Normals::Ptr normals (new Normals);
  timed (task.time_of_normals, [&] {
    pcl::NormalEstimation<pcl::PointXYZ, pcl::Normal> estimation;
    estimation.setInputCloud (task.cloud);
    estimation.setSearchMethod (tree);
    estimation.setKSearch (task.values.neighbors);
    estimation.compute (*normals);
  });
  pcl::RegionGrowing<pcl::PointXYZ, pcl::Normal> growing;
  growing.setInputCloud (task.cloud);
  growing.setInputNormals (normals);
  growing.setSearchMethod (tree);
  growing.setNumberOfNeighbours (unsigned (task.values.neighbors));
  // The angle of the paper; PCL's tutorial has 3 degrees.
  growing.setSmoothnessThreshold (float (paper_angle_tolerance));
  growing.setCurvatureThreshold (1.0f); // as in PCL's tutorial: normals alone decide
  growing.setMinClusterSize (pcl::uindex_t (task.minPoints (min_points_of_region)));
  Planes regions;
  growing.extract (regions);
  return regions;
}

namespace {

Normals::Ptr
normalsOfImage (const XyzCloud::ConstPtr& image)
{
  // The values of PCL's program openni_organized_multi_plane_segmentation.
  constexpr float max_depth_change = 0.03f; // relative to the depth
  constexpr float smoothing = 20.0f;        // edge of the window [px]
  Normals::Ptr normals (new Normals);
  pcl::IntegralImageNormalEstimation<pcl::PointXYZ, pcl::Normal> estimation;
  estimation.setNormalEstimationMethod (estimation.COVARIANCE_MATRIX);
  estimation.setMaxDepthChangeFactor (max_depth_change);
  estimation.setNormalSmoothingSize (smoothing);
  estimation.setInputCloud (image);
  estimation.compute (*normals);
  return normals;
}

/** Replaces indices of pixels by those of points: the cloud of a task has the finite
 * points of the image alone. */
void
replacePixelsByPoints (const XyzCloud& image, Planes& planes)
{
  pcl::Indices point_of_pixel;
  pcl::index_t points = 0;
  for (const pcl::PointXYZ& point : image) {
    point_of_pixel.push_back (points);
    if (pcl::isXYZFinite (point))
      ++points;
  }
  for (pcl::PointIndices& plane : planes)
    for (pcl::index_t& i : plane.indices)
      i = point_of_pixel[i];
}

} // namespace

Planes
planesInImage (const PeerTask& task)
{
  // The values of PCL's program openni_organized_multi_plane_segmentation.
  const double max_angle = pcl::deg2rad (2.0); // between normals [rad]
  constexpr double demo_distance = 0.02;       // to a plane, at a depth of 1 m [m]
  const XyzCloud::Ptr image = inCameraFrame (*task.settings.image);
  Normals::Ptr normals;
  timed (task.time_of_normals, [&] { normals = normalsOfImage (image); });
  pcl::OrganizedMultiPlaneSegmentation<pcl::PointXYZ, pcl::Normal, pcl::Label> finder;
  finder.setMinInliers (unsigned (task.minPoints (min_points_of_region)));
  finder.setAngularThreshold (max_angle);
  finder.setDistanceThreshold (
      task.source == ValuesFrom::Tutorial ? demo_distance : task.values.threshold);
  finder.setInputNormals (normals);
  finder.setInputCloud (image);
  Planes planes;
  // The other results of segmentAndRefine are not used.
  std::vector<pcl::PlanarRegion<pcl::PointXYZ>,
              Eigen::aligned_allocator<pcl::PlanarRegion<pcl::PointXYZ>>>
      regions;
  std::vector<pcl::ModelCoefficients> models;
  Planes pixels_of_labels;
  Planes borders;
  pcl::PointCloud<pcl::Label>::Ptr labels (new pcl::PointCloud<pcl::Label>);
  finder.segmentAndRefine (regions, models, planes, labels, pixels_of_labels, borders);
  replacePixelsByPoints (*image, planes);
  return planes;
}

} // namespace pcl_ops::evaluation
