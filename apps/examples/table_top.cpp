// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause

// Finds a table in front of a depth camera and the objects on it, frame by frame.
#include <pcl/io/pcd_io.h>
#include <pcl/segmentation/extract_polygonal_prism_data.h>

#include <pcl_ops/oriented_point_sampling.h>
#include <pcl_ops/plane_extent.h>
#include <pcl_ops/up_axis.h>

#include <algorithm>
#include <cstdio>

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

/** \brief Returns the points over the hull of a plane that are higher than four times
 * its rms distance, at least 1 cm, and up to half a meter. */
static pcl::PointIndices
objectsOn (const pcl_ops::PlaneSegment& table,
           const pcl_ops::PlaneExtent& extent,
           const Cloud::ConstPtr& cloud)
{
  const Cloud::Ptr hull (new Cloud);
  for (const Eigen::Vector3d& corner : extent.hull)
    hull->push_back (pcl::PointXYZ (corner.x(), corner.y(), corner.z()));
  pcl::ExtractPolygonalPrismData<pcl::PointXYZ> prism;
  prism.setInputCloud (cloud);
  prism.setInputPlanarHull (hull);
  const Eigen::Vector3f sensor = cloud->sensor_origin_.head<3>();
  prism.setViewPoint (sensor.x(), sensor.y(), sensor.z());
  constexpr double min_height = 0.01, max_height = 0.5; // [m]
  prism.setHeightLimits (std::max (min_height, 4.0 * table.rms()), max_height);
  pcl::PointIndices objects;
  prism.segment (objects);
  return objects;
}

/** \brief Prints the size of the table, the largest horizontal plane, and the number of
 * points above it.
 * \param[in] planes in descending order of points
 * \param[in] duration of the detection [ms] */
static void
printTable (const std::vector<pcl_ops::PlaneSegment>& planes,
            const Cloud::ConstPtr& cloud,
            double duration)
{
  const auto table = std::find_if (planes.begin(), planes.end(), [] (auto& plane) {
    return plane.orientation == pcl_ops::Orientation::Horizontal;
  });
  if (table == planes.end()) {
    std::printf ("no horizontal plane among %zu\n", planes.size());
    return;
  }
  const pcl_ops::PlaneExtent extent = pcl_ops::planeExtent (*cloud, *table);
  std::printf ("%5.1f ms: table of %zu points, %.2f m^2, %zu points above it\n",
               duration,
               table->inliers.size(),
               extent.area,
               objectsOn (*table, extent, cloud).indices.size());
}

int
main (int argc, char** argv)
{
  const Cloud::Ptr cloud (new Cloud);
  if (argc != 2 || pcl::io::loadPCDFile (argv[1], *cloud) < 0) {
    std::fprintf (stderr, "Usage: table_top CLOUD.pcd\n");
    return 2;
  }

  // One object for all frames: later calls reuse the memory that the first allocates.
  pcl_ops::OrientedPointSampling<pcl::PointXYZ> ops;
  // The up axis of a level camera. If the camera is tilted, the planes of frame 0 tell
  // it.
  ops.setUpAxis (pcl_ops::cameraUp());
  // Merges parts of the table that clutter divides, if the centroid of each is less
  // than 1 cm from the plane of the other.
  pcl_ops::MergingParameters merging;
  merging.distance_threshold = 0.01; // [m]
  ops.setMergingParameters (merging);
  constexpr int frames = 5; // the same cloud again and again, in place of a camera
  for (int frame = 0; frame < frames; ++frame) {
    ops.setInputCloud (cloud);
    std::vector<pcl_ops::PlaneSegment> planes;
    if (!ops.segment (planes))
      return 1;
    if (frame == 0) {
      const Eigen::Vector3d sensor = cloud->sensor_origin_.head<3>().cast<double>();
      if (const auto up = pcl_ops::estimateUpAxis (planes, sensor))
        ops.setUpAxis (up->direction);
      continue;
    }
    printTable (planes, cloud, ops.getStageDurations().detection);
  }
}
