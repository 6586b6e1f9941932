// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "presets.h"
#include "scene.h"
#include <pcl_ops/detect_planes.h>

#include <cstddef>
#include <stdexcept>

using namespace pcl_ops;

namespace {

/** \brief A layout that no point type of PCL has. */
struct TimedPoint {
  double seconds;
  float x, y, z;
};

std::vector<TimedPoint>
timed (const Cloud& cloud)
{
  std::vector<TimedPoint> points;
  for (const pcl::PointXYZ& point : cloud)
    points.push_back ({0.0, point.x, point.y, point.z});
  return points;
}

CloudView
viewOf (const std::vector<TimedPoint>& points)
{
  return {points.data(), offsetof (TimedPoint, x), sizeof (TimedPoint), points.size()};
}

template <typename Detector>
void
expectSameInliers ()
{
  const auto scene = room().noise (5_mm).build();
  const std::vector<TimedPoint> points = timed (*scene.cloud);
  Detector detector;
  detector.setInputCloud (scene.cloud);
  std::vector<pcl::Indices> inliers;
  for (const PlaneSegment& plane :
       detectPlanes (viewOf (points), detector.getParameters()))
    inliers.push_back (plane.inliers);
  EXPECT_EQ (inliers, inliersOf (detector));
}

} // namespace

TEST (DetectPlanes, FindsInABufferWhatTheClassesFindInACloud)
{
  expectSameInliers<OrientedPointSampling<pcl::PointXYZ>>();
  expectSameInliers<FastSamplingPlaneFiltering<pcl::PointXYZ>>();
  expectSameInliers<KernelHoughTransform<pcl::PointXYZ>>();
}

TEST (DetectPlanes, ThrowsForMisuse)
{
  OrientedPointSamplingParameters wrong;
  wrong.sampling_rate = 0.0;
  const std::vector<TimedPoint> points (3);
  EXPECT_THROW (detectPlanes (CloudView(), OrientedPointSamplingParameters()),
                std::invalid_argument);
  EXPECT_THROW (detectPlanes (viewOf (points), wrong), std::invalid_argument);
}

TEST (CloudView, RefusesBuffersWhosePositionsAreNoAlignedFloats)
{
  const std::vector<float> buffer (100);
  EXPECT_NO_THROW (CloudView (buffer.data(), 4, 16, 6));
  EXPECT_THROW (CloudView (buffer.data(), 5, 16, 6), std::invalid_argument);
  EXPECT_THROW (CloudView (buffer.data(), 4, 18, 6), std::invalid_argument);
}
