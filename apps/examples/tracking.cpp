// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause

// Planes keep their numbers while a sensor moves, although its odometry has errors.
#include <pcl/common/transforms.h>
#include <pcl/io/pcd_io.h>

#include <pcl_ops/oriented_point_sampling.h>
#include <pcl_ops/plane_tracker.h>

#include <cstdio>

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

int
main (int argc, char** argv)
{
  const Cloud::Ptr room (new Cloud);
  if (argc != 2 || pcl::io::loadPCDFile (argv[1], *room) < 0) {
    std::fprintf (stderr, "Usage: tracking CLOUD.pcd\n");
    return 2;
  }

  pcl_ops::PlaneTracker tracker;
  // Pose of the sensor in the room: the true one, and the one that odometry gives.
  Eigen::Isometry3d truth = Eigen::Isometry3d::Identity();
  Eigen::Isometry3d odometry = truth;
  constexpr int frames = 5;
  for (int frame_number = 0; frame_number < frames; ++frame_number) {
    const Cloud::Ptr frame (new Cloud); // the room in the frame of the sensor
    pcl::transformPointCloud (*room, *frame, truth.inverse().matrix().cast<float>());
    pcl_ops::OrientedPointSampling<pcl::PointXYZ> ops;
    ops.setInputCloud (frame);
    std::vector<pcl_ops::PlaneSegment> planes;
    if (!ops.segment (planes))
      return 1;

    const std::vector<std::uint32_t> numbers = tracker.track (planes, odometry);
    std::printf ("frame %d, planes", frame_number);
    for (const std::uint32_t number : numbers)
      std::printf (" %u", number);
    const Eigen::AngleAxisd error_by_odometry (truth.linear().transpose() *
                                               odometry.linear());
    const Eigen::AngleAxisd error_by_planes (truth.linear().transpose() *
                                             tracker.pose().linear());
    std::printf (
        "\n  the rotation is off by %.1f degrees by odometry, by %.1f by planes\n",
        error_by_odometry.angle() * 180.0 / M_PI,
        error_by_planes.angle() * 180.0 / M_PI);

    // The sensor moves by 5 cm along x and 2 cm along y, and turns by 0.1 rad. Odometry
    // measures only 0.08 rad.
    truth.translate (Eigen::Vector3d (0.05, 0.02, 0.0));
    truth.rotate (Eigen::AngleAxisd (0.1, Eigen::Vector3d::UnitZ()));
    odometry.translate (Eigen::Vector3d (0.05, 0.02, 0.0));
    odometry.rotate (Eigen::AngleAxisd (0.08, Eigen::Vector3d::UnitZ()));
  }
}
