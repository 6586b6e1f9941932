// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause

// Reads a scan of KITTI into the bytes of a PointCloud2 and finds planes in them,
// without a copy of the points. It links only pcl_ops::core, and no library of PCL.
#include <pcl/PCLPointCloud2.h> // header only, in place of sensor_msgs

#include <pcl_ops/detect_planes.h>
#include <pcl_ops/plane_extent.h>

#include <cstdio>
#include <fstream>

/** \brief Returns a view of a PointCloud2 message of ROS 1 or ROS 2. Its fields x, y
 * and z must be float32 side by side, as drivers write them. */
template <typename PointCloud2>
static pcl_ops::CloudView
viewOf (const PointCloud2& message)
{
  std::size_t offset_of_x = 0;
  for (const auto& field : message.fields)
    if (field.name == "x")
      offset_of_x = field.offset;
  const std::size_t points = std::size_t (message.width) * message.height;
  return {message.data.data(), offset_of_x, message.point_step, points};
}

int
main (int argc, char** argv)
{
  std::ifstream file (argc == 2 ? argv[1] : "", std::ios::binary);
  // The list of fields stays empty: then viewOf takes the first number for x.
  pcl::PCLPointCloud2 message;
  message.data.assign (std::istreambuf_iterator<char> (file), {});
  message.point_step = 4 * sizeof (float); // x, y, z and intensity
  message.height = 1;
  message.width = message.data.size() / message.point_step;
  if (message.width == 0) {
    std::fprintf (stderr, "Usage: cloud_view SCAN.bin\n");
    return 2;
  }

  const pcl_ops::CloudView cloud = viewOf (message);
  const pcl_ops::OrientedPointSamplingParameters parameters;
  for (const pcl_ops::PlaneSegment& plane : pcl_ops::detectPlanes (cloud, parameters))
    std::printf ("%zu points, %s, %.2f m^2, height %.2f m\n",
                 plane.inliers.size(),
                 pcl_ops::toString (plane.orientation),
                 pcl_ops::planeExtent (cloud, plane).area,
                 plane.centroid.z());
}
