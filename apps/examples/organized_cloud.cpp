// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause

// Measures the time of two neighbor searches for the paper's OPS on a depth image:
// GridSearch, and OrganizedNeighbor, which uses the rows and columns of the image.
#include <pcl/io/pcd_io.h>
#include <pcl/search/organized.h>

#include <pcl_ops/oriented_point_sampling.h>

#include <cstdio>

using Ops = pcl_ops::OrientedPointSampling<pcl::PointXYZ>;

/** \brief Finds the planes and prints how long the neighbor search took.
 * \return whether planes were found */
static bool
printTimes (const char* name_of_search, Ops& ops)
{
  std::vector<pcl_ops::PlaneSegment> planes;
  if (!ops.segment (planes))
    return false;
  const pcl_ops::StageDurations& time = ops.getStageDurations();
  std::printf ("%-18s %3zu planes, search ready after %5.1f ms, normals in %5.1f ms\n",
               name_of_search,
               planes.size(),
               time.search,
               time.normals);
  return true;
}

int
main (int argc, char** argv)
{
  const pcl::PointCloud<pcl::PointXYZ>::Ptr cloud (new pcl::PointCloud<pcl::PointXYZ>);
  if (argc != 2 || pcl::io::loadPCDFile (argv[1], *cloud) < 0) {
    std::fprintf (stderr, "Usage: organized_cloud CLOUD.pcd\n");
    return 2;
  }
  if (!cloud->isOrganized()) {
    std::fprintf (stderr, "%s: has no rows; give a depth image\n", argv[1]);
    return 1;
  }

  Ops ops;
  ops.setInputCloud (cloud);
  // Only Sampling::Points, the paper's preset, uses the search method.
  ops.setParameters (pcl_ops::OrientedPointSamplingParameters::paper());
  bool found_planes = printTimes ("GridSearch", ops);
  using OrganizedNeighbor = pcl::search::OrganizedNeighbor<pcl::PointXYZ>;
  ops.setSearchMethod (pcl::make_shared<OrganizedNeighbor>());
  found_planes = printTimes ("OrganizedNeighbor", ops) && found_planes;
  return found_planes ? 0 : 1;
}
