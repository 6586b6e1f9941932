// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause

// Finds the edges and corners where planes meet, a wireframe of the scene, and prints
// them with the indices of their planes in the list of planes, from 0.
#include <pcl/common/angles.h>
#include <pcl/io/pcd_io.h>

#include <pcl_ops/oriented_point_sampling.h>
#include <pcl_ops/plane_edges.h>

#include <cstdio>

int
main (int argc, char** argv)
{
  const pcl::PointCloud<pcl::PointXYZ>::Ptr cloud (new pcl::PointCloud<pcl::PointXYZ>);
  if (argc != 2 || pcl::io::loadPCDFile (argv[1], *cloud) < 0) {
    std::fprintf (stderr, "Usage: edges CLOUD.pcd\n");
    return 2;
  }
  pcl_ops::OrientedPointSampling<pcl::PointXYZ> ops;
  ops.setInputCloud (cloud);
  std::vector<pcl_ops::PlaneSegment> planes;
  if (!ops.segment (planes))
    return 1;

  // Other distances follow the noise and point density of the planes by default.
  pcl_ops::PlaneEdgeParameters parameters;
  parameters.min_length = 0.2; // [m]
  const pcl_ops::PlaneEdges found =
      pcl_ops::findPlaneEdges (*cloud, planes, parameters);
  std::printf ("%zu edges, %zu corners\n", found.edges.size(), found.corners.size());
  for (const pcl_ops::PlaneEdge& edge : found.edges)
    std::printf ("%5.2f m of planes %zu and %zu, at %.0f degrees\n",
                 edge.length(),
                 edge.planes[0],
                 edge.planes[1],
                 pcl::rad2deg (edge.angle));
  for (const pcl_ops::PlaneCorner& corner : found.corners)
    std::printf ("corner of planes %zu, %zu and %zu: (%.2f, %.2f, %.2f)\n",
                 corner.planes[0],
                 corner.planes[1],
                 corner.planes[2],
                 corner.position.x(),
                 corner.position.y(),
                 corner.position.z());
}
