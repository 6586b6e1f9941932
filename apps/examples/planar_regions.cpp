// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause

// Prints where planes end: as PCL's planar regions, and as rectangles with areas.
#include <pcl/io/pcd_io.h>

#include <pcl_ops/oriented_point_sampling.h>
#include <pcl_ops/plane_extent.h>

#include <cstdio>

using Ops = pcl_ops::OrientedPointSampling<pcl::PointXYZ>;

int
main (int argc, char** argv)
{
  const pcl::PointCloud<pcl::PointXYZ>::Ptr cloud (new pcl::PointCloud<pcl::PointXYZ>);
  if (argc != 2 || pcl::io::loadPCDFile (argv[1], *cloud) < 0) {
    std::fprintf (stderr, "Usage: planar_regions CLOUD.pcd\n");
    return 2;
  }
  Ops ops;
  ops.setInputCloud (cloud);

  // The same type of result as pcl::OrganizedMultiPlaneSegmentation gives.
  Ops::PlanarRegions regions;
  if (!ops.segment (regions))
    return 1;
  std::printf ("%zu regions, the largest with %zu corners\n",
               regions.size(),
               regions.empty() ? 0 : regions.front().getContour().size());

  // The sides of the smallest rectangle around a plane and the area of its convex hull
  // tell whether it may be a table.
  std::vector<pcl_ops::PlaneSegment> planes;
  ops.segment (planes);
  for (const pcl_ops::PlaneSegment& plane : planes) {
    const pcl_ops::PlaneExtent extent = pcl_ops::planeExtent (*cloud, plane);
    std::printf ("%5.2f m x %4.2f m, %6.3f m^2, %s\n",
                 extent.length,
                 extent.width,
                 extent.area,
                 pcl_ops::toString (plane.orientation));
  }
}
