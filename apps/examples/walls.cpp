// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause

// Keeps the vertical planes that are large and wide enough to be walls of a room.
// Prints how many planes each test dropped, and for each wall its area and the
// direction of its normal: degrees from the x axis towards the y axis.
#include <pcl/common/angles.h>
#include <pcl/io/pcd_io.h>

#include <pcl_ops/oriented_point_sampling.h>
#include <pcl_ops/plane_extent.h>
#include <pcl_ops/plane_filter.h>

#include <cmath>
#include <cstdio>

int
main (int argc, char** argv)
{
  const pcl::PointCloud<pcl::PointXYZ>::Ptr cloud (new pcl::PointCloud<pcl::PointXYZ>);
  if (argc != 2 || pcl::io::loadPCDFile (argv[1], *cloud) < 0) {
    std::fprintf (stderr, "Usage: walls CLOUD.pcd\n");
    return 2;
  }
  pcl_ops::OrientedPointSampling<pcl::PointXYZ> ops;
  ops.setInputCloud (cloud);
  std::vector<pcl_ops::PlaneSegment> planes;
  if (!ops.segment (planes))
    return 1;

  pcl_ops::PlaneFilter walls;
  walls.orientation = pcl_ops::Orientation::Vertical;
  walls.min_area = 1.0;  // [m^2]
  walls.min_width = 0.5; // [m]
  const pcl_ops::DroppedPlanes dropped = pcl_ops::filterPlanes (planes, walls, *cloud);
  std::printf ("%zu walls; left out: %zu not vertical, %zu too small, %zu too narrow\n",
               planes.size(),
               dropped.by_orientation,
               dropped.by_area,
               dropped.by_width);
  for (const pcl_ops::PlaneSegment& wall : planes) {
    const pcl_ops::PlaneExtent extent = pcl_ops::planeExtent (*cloud, wall);
    const double azimuth = std::atan2 (wall.normal.y(), wall.normal.x());
    std::printf (
        "%5.2f m^2, faces %4.0f degrees\n", extent.area, pcl::rad2deg (azimuth));
  }
}
