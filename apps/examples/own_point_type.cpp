// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause

// Uses a point type that PCL does not know: PCL_NO_PRECOMPILE makes this file compile
// the templates of PCL and pcl_ops for it.
#define PCL_NO_PRECOMPILE
#include <pcl/io/pcd_io.h>
#include <pcl/register_point_struct.h>

#include <pcl_ops/oriented_point_sampling.h>

#include <cstdio>

struct ThermalPoint {
  PCL_ADD_POINT4D;
  float temperature;
  PCL_MAKE_ALIGNED_OPERATOR_NEW
};
POINT_CLOUD_REGISTER_POINT_STRUCT (
    ThermalPoint,
    (float, x, x) (float, y, y) (float, z, z) (float, temperature, temperature))

int
main (int argc, char** argv)
{
  const pcl::PointCloud<ThermalPoint>::Ptr cloud (new pcl::PointCloud<ThermalPoint>);
  if (argc != 2 || pcl::io::loadPCDFile (argv[1], *cloud) < 0) {
    std::fprintf (stderr, "Usage: own_point_type CLOUD.pcd\n");
    return 2;
  }
  // Points without a temperature get one for this example: 20 degrees Celsius at height
  // 0, and 2 more per meter.
  for (ThermalPoint& point : *cloud)
    if (!(point.temperature > 0.0f))
      point.temperature = 20.0f + 2.0f * point.z;

  pcl_ops::OrientedPointSampling<ThermalPoint> ops;
  ops.setInputCloud (cloud);
  std::vector<pcl_ops::PlaneSegment> planes;
  if (!ops.segment (planes))
    return 1;
  for (const pcl_ops::PlaneSegment& plane : planes) {
    double sum_of_temperatures = 0.0;
    for (const pcl::index_t index : plane.inliers)
      sum_of_temperatures += (*cloud)[index].temperature;
    std::printf ("%6zu points at %.1f degrees\n",
                 plane.inliers.size(),
                 sum_of_temperatures / static_cast<double> (plane.inliers.size()));
  }
  std::printf ("%zu planes\n", planes.size());
}
